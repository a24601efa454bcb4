#include "idiophone/timbre/nodes/node_types.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <utility>

namespace idiophone::timbre {

namespace {

/// Graphs point to their types: a deque does not move them when others are added.
std::deque<NodeType>& known_types() {
  static std::deque<NodeType> all = [] {
    std::deque<NodeType> types;
    for (auto* topic : {&functions, &oscillators, &noises, &filters, &delays, &recordings, &vectors}) {
      std::ranges::move(topic(), std::back_inserter(types));
    }
    return types;
  }();
  return all;
}

}  // namespace

std::string NodeType::usage() const {
  std::string text = "(" + name;
  for (const Argument& argument : arguments) {
    if (argument.default_value) {
      text += fmt::format(" [{} = {}]", argument.name, *argument.default_value);
    } else {
      text += " " + argument.name;
    }
  }
  return text + (repeats ? " ...)" : ")");
}

const std::deque<NodeType>& node_types() {
  return known_types();
}

void add_node_types(std::vector<NodeType> types) {
  for (NodeType& type : types) {
    if (is_constant_word(type.name) || find_node_type(type.name) != nullptr) {
      throw std::invalid_argument(fmt::format("there is a node or a constant '{}' already", type.name));
    }
    known_types().push_back(std::move(type));
  }
}

const NodeType* find_node_type(const std::string& name) {
  const auto found = std::ranges::find(node_types(), name, &NodeType::name);
  return found == node_types().end() ? nullptr : &*found;
}

bool is_constant_word(const std::string& word) {
  return word == "pi" || word == "rate";
}

}  // namespace idiophone::timbre
