#include "idiophone/timbre/nodes/node_types.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace idiophone::timbre {

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

const std::vector<NodeType>& node_types() {
  static const std::vector<NodeType> all = [] {
    std::vector<NodeType> types;
    for (auto* topic : {&functions, &oscillators, &noises, &filters, &delays, &recordings, &vectors, &bodies}) {
      std::ranges::move(topic(), std::back_inserter(types));
    }
    return types;
  }();
  return all;
}

const NodeType* find_node_type(const std::string& name) {
  const auto found = std::ranges::find(node_types(), name, &NodeType::name);
  return found == node_types().end() ? nullptr : &*found;
}

bool is_constant_word(const std::string& word) {
  return word == "pi" || word == "rate";
}

}  // namespace idiophone::timbre
