#pragma once
// Single values of a deck. Each read() puts the value into its argument, or reports the mistake, leaves the argument as
// it was and returns false. Each to_node() makes the text that is read as the value; a node of nothing where a deck has
// no text for it.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <concepts>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "idiophone/foundation/deck/mistakes.hpp"
#include "idiophone/foundation/deck/node.hpp"
#include "idiophone/foundation/deck/suggestion.hpp"
#include "idiophone/foundation/types.hpp"

namespace idiophone::deck {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The numbers a key may take; all finite ones where no bound is given.
struct Range {
  double above = -infinity;     ///< exclusive
  double at_least = -infinity;  ///< inclusive
  double below = infinity;      ///< exclusive
  double at_most = infinity;    ///< inclusive
  std::string_view unit{};      ///< for messages; may be empty

  [[nodiscard]] bool contains(double number) const {
    return number > above && number >= at_least && number < below && number <= at_most;
  }
};

/// The words a key may take and what each stands for.
template <class T>
struct Choices {
  std::vector<std::pair<std::string, T>> words;
};

/// The folder that relative file names start from.
struct Folder {
  std::filesystem::path path;
};

/// A scalar.
[[nodiscard]] Node scalar(const std::string& text);

/// What a value is, for "found ...": "'text'", of which at most 60 bytes, "a list of 2", "a map", "nothing".
[[nodiscard]] std::string describe(const Node& node);

/// A finite number: 5, -0.5, 1e-3. Quoted digits are text.
bool read(const Node& node, Mistakes& mistakes, double& number, const Range& range);

/// Nothing for an infinite number, which stands for "no end".
[[nodiscard]] Node to_node(double number, const Range& range);

/// A whole number; 44.1e3 is one.
bool read(const Node& node, Mistakes& mistakes, int& number, const Range& range);
[[nodiscard]] Node to_node(int number, const Range& range);

/// A list of three numbers, each in the range.
bool read(const Node& node, Mistakes& mistakes, Vector3& vector, const Range& range);
[[nodiscard]] Node to_node(const Vector3& vector, const Range& range);

/// Any text but the empty one.
bool read(const Node& node, Mistakes& mistakes, std::string& text);
[[nodiscard]] Node to_node(const std::string& text);

/// The name of an existing file; becomes absolute or relative to the working directory.
bool read(const Node& node, Mistakes& mistakes, std::filesystem::path& file, const Folder& folder);
[[nodiscard]] Node to_node(const std::filesystem::path& file, const Folder& folder);

/// Accepts names that files and datasets can be called after: 1 to 64 letters, digits, - and _, no - at the start.
bool check_name(const std::string& name, const Location& where, Mistakes& mistakes);

/// One of a few words. Fails silently where there are none: what should have given them is then wrong already.
template <class T>
bool read(const Node& node, Mistakes& mistakes, T& choice, const Choices<T>& choices) {
  if (choices.words.empty()) {
    return false;
  }
  std::vector<std::string> known;
  for (const auto& [word, meaning] : choices.words) {
    if (node.kind == Node::Kind::scalar && node.text == word) {
      choice = meaning;
      return true;
    }
    known.push_back(word);
  }
  return mistakes.add(node, fmt::format("must be one of {}, found {}{}", fmt::join(known, ", "), describe(node),
                                        suggestion(node.text, known)));
}

/// The word for a choice; nothing where there is none.
template <class T>
[[nodiscard]] Node to_node(const T& choice, const Choices<T>& choices) {
  for (const auto& [word, meaning] : choices.words) {
    if (meaning == choice) {
      return scalar(word);
    }
  }
  return {};
}

/// A value without a default.
template <class T, class... Rules>
bool read(const Node& node, Mistakes& mistakes, std::optional<T>& value, const Rules&... rules) {
  T present{};
  if (!read(node, mistakes, present, rules...)) {
    return false;
  }
  value = present;
  return true;
}

}  // namespace idiophone::deck
