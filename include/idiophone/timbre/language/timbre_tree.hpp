#pragma once
// A timbre tree: parameters, named parts, and the expression of its sound (Hahn 1995, "Representation using timbre
// trees").

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "idiophone/timbre/language/expression.hpp"

namespace idiophone::timbre {

/// (parameter NAME) or (parameter NAME DEFAULT)
struct Parameter {
  std::string name{};
  std::optional<double> default_value{};
  deck::Location where{};
};

/// (define NAME EXPRESSION)
struct Definition {
  std::string name;
  Expression expression;
};

/// A class of sounds.
struct Tree {
  std::filesystem::path file;  ///< where relative names of sound files start from
  std::vector<Parameter> parameters;
  std::vector<Definition> definitions;
  Expression sound;
};

/// A tree from its text.
/// @param file  that mistakes are said to be in
/// @throws deck::DeckError for a text that is no tree
[[nodiscard]] Tree parse_tree(const std::string& text, const std::filesystem::path& file);

/// @throws also std::runtime_error if the file can't be read
[[nodiscard]] Tree read_tree_file(const std::filesystem::path& file);

/// The tree as text, which parse_tree() reads back.
[[nodiscard]] std::string to_text(const Tree& tree);

}  // namespace idiophone::timbre
