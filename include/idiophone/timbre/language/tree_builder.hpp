#pragma once
// Timbre trees from C++ (Hahn 1995, the functional interface): functions that make the same expressions as a text.

#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "idiophone/timbre/language/timbre_tree.hpp"

namespace idiophone::timbre {

/// What a node can have as an argument: an expression or a number.
struct Operand {
  Operand(Expression given) : expression(std::move(given)) {}  // NOLINT(google-explicit-constructor)
  Operand(double number)                                       // NOLINT(google-explicit-constructor)
      : expression{.kind = Expression::Kind::number, .number = number} {}
  Expression expression;
};

/// A node: node("sine", 440.0) is (sine 440). docs/use/timbre_trees.md has the names.
template <class... Operands>
[[nodiscard]] Expression node(const std::string& name, const Operands&... operands) {
  Expression call{.kind = Expression::Kind::list};
  call.items.push_back({.kind = Expression::Kind::word, .text = name});
  (call.items.push_back(Operand(operands).expression), ...);
  return call;
}

/// A word, for example the interpolation of (keyframes ...).
[[nodiscard]] Expression word(const std::string& name);
/// A text in quotes, for example the name of a sound file.
[[nodiscard]] Expression text(const std::string& content);

[[nodiscard]] Expression operator+(const Operand& a, const Operand& b);
[[nodiscard]] Expression operator-(const Operand& a, const Operand& b);
[[nodiscard]] Expression operator*(const Operand& a, const Operand& b);
[[nodiscard]] Expression operator/(const Operand& a, const Operand& b);
[[nodiscard]] Expression operator-(const Operand& a);

/// Parameters, definitions and the sound of one tree.
class TreeBuilder {
 public:
  /// @param name  of the tree, for messages; relative names of sound files start from its folder
  explicit TreeBuilder(std::filesystem::path name) { tree_.file = std::move(name); }

  /// Declares (parameter NAME) or (parameter NAME DEFAULT).
  /// @return the parameter as an operand
  Expression parameter(const std::string& name, std::optional<double> default_value = {});

  /// Declares (define NAME EXPRESSION).
  /// @return the definition as an operand
  Expression define(const std::string& name, const Operand& value);

  /// The tree. Its text is to_text(tree); messages name the lines of that text.
  /// @throws deck::DeckError for names that are no names, that occur twice or that have another meaning
  [[nodiscard]] Tree finish(const Operand& sound) const;

 private:
  Tree tree_;
};

}  // namespace idiophone::timbre
