#include "idiophone/timbre/language/tree_builder.hpp"

namespace idiophone::timbre {

Expression word(const std::string& name) {
  return {.kind = Expression::Kind::word, .text = name};
}

Expression text(const std::string& content) {
  return {.kind = Expression::Kind::text, .text = content};
}

Expression operator+(const Operand& a, const Operand& b) {
  return node("+", a, b);
}

Expression operator-(const Operand& a, const Operand& b) {
  return node("-", a, b);
}

Expression operator*(const Operand& a, const Operand& b) {
  return node("*", a, b);
}

Expression operator/(const Operand& a, const Operand& b) {
  return node("/", a, b);
}

Expression operator-(const Operand& a) {
  return node("-", a);
}

Expression TreeBuilder::parameter(const std::string& name, std::optional<double> default_value) {
  tree_.parameters.push_back({.name = name, .default_value = default_value});
  return word(name);
}

Expression TreeBuilder::define(const std::string& name, const Operand& value) {
  tree_.definitions.push_back({.name = name, .expression = value.expression});
  return word(name);
}

Tree TreeBuilder::finish(const Operand& sound) const {
  Tree whole = tree_;
  whole.sound = sound.expression;
  return parse_tree(to_text(whole), tree_.file);  // the same checks as for a text, and places for messages
}

}  // namespace idiophone::timbre
