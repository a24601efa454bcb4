#pragma once
// The text of a timbre tree: s-expressions, each with its place.

#include <string>
#include <vector>

#include "idiophone/foundation/deck/location.hpp"

namespace idiophone::timbre {

/// A number, a word, a quoted text, or a list in parentheses.
struct Expression {
  enum class Kind { number, word, text, list };
  Kind kind = Kind::list;
  deck::Location where{};
  double number = 0.0;
  std::string text{};               ///< of a word or a text, without quotes
  std::vector<Expression> items{};  ///< of a list
};

/// Lists inside lists, and nodes inside nodes, can be this deep. Code that walks over a tree may recurse.
inline constexpr int deepest = 1000;

/// All expressions of a text. A semicolon begins a comment, which ends with the line.
/// @param file  that mistakes are said to be in
/// @throws deck::DeckError for parentheses and quotes without partner, and for lists deeper than `deepest`
[[nodiscard]] std::vector<Expression> read_expressions(const std::string& text, const std::string& file);

/// The expression as text, on one line.
[[nodiscard]] std::string to_text(const Expression& expression);

/// What an expression is, for "found ...": "3", "'sine'", "a list".
[[nodiscard]] std::string describe(const Expression& expression);

}  // namespace idiophone::timbre
