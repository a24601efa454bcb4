#include "graph_builder.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <numbers>
#include <utility>

#include "idiophone/foundation/deck/suggestion.hpp"
#include "idiophone/timbre/nodes/control.hpp"
#include "idiophone/timbre/nodes/curve_node.hpp"

namespace idiophone::timbre {

void GraphBuilder::build() {
  for (const Definition& definition : tree_.definitions) {
    named_[definition.name].definition = &definition;
  }
  check_bindings();
  const Value root = build(tree_.sound, 1);
  for (auto& [name, named] : named_) {  // mistakes of parts that nobody uses, too
    if (!named.is_done) {
      build_definition(named, named.definition->expression, 1);
    }
  }
  if (root && graph_.values_[*root].width > 1) {
    complain(tree_.sound.where, fmt::format("the sound is {}; add its components up by (combine ...)", kind_of(*root)));
  }
  mistakes_.raise();
  graph_.root_ = *root;
}

void GraphBuilder::check_bindings() {
  std::vector<std::string> names;
  for (const Parameter& parameter : tree_.parameters) {
    names.push_back(parameter.name);
  }
  for (const auto& [name, binding] : bindings_) {
    if (std::ranges::find(names, name) == names.end()) {
      complain(binding.where, fmt::format("{} has no parameter '{}'{}", tree_.file.filename().string(), name,
                                          deck::suggestion(name, names)));
    }
  }
}

GraphBuilder::Value GraphBuilder::build(const Expression& expression, int depth) {
  if (depth > deepest) {
    if (!std::exchange(is_too_deep_, true)) {
      complain(expression.where, fmt::format("the tree is more than {} nodes deep", deepest));
    }
    return {};
  }
  switch (expression.kind) {
    case Expression::Kind::number:
      return constant({expression.number});
    case Expression::Kind::word:
      return build_word(expression, depth);
    case Expression::Kind::text:
      return complain(expression.where, "expected a number, a name or a list, found " + describe(expression));
    case Expression::Kind::list:
      break;
  }
  return build_call(expression, depth);
}

GraphBuilder::Value GraphBuilder::build_word(const Expression& word, int depth) {
  if (word.text == "pi") {
    return constant({std::numbers::pi});
  }
  if (word.text == "rate") {
    return constant({static_cast<double>(sound_start_.rate)});
  }
  if (const auto named = named_.find(word.text); named != named_.end()) {
    return build_definition(named->second, word, depth);
  }
  const auto parameter = std::ranges::find(tree_.parameters, word.text, &Parameter::name);
  if (parameter != tree_.parameters.end()) {
    return build_parameter(*parameter);
  }
  if (const NodeType* type = find_node_type(word.text)) {
    return build_node(*type, word.where, {}, depth);
  }
  return complain(word.where, fmt::format("there is no '{}'{}", word.text, deck::suggestion(word.text, known_words())));
}

GraphBuilder::Value GraphBuilder::build_parameter(const Parameter& parameter) {
  const auto known = parameters_.find(parameter.name);
  if (known != parameters_.end()) {
    return known->second;
  }
  Value& value = parameters_[parameter.name];
  const auto binding = bindings_.find(parameter.name);
  if (binding == bindings_.end()) {
    value = parameter.default_value
                ? Value(constant({*parameter.default_value}))
                : complain(parameter.where,
                           fmt::format("the parameter '{}' has no default and is not given a value", parameter.name));
  } else if (const auto* number = std::get_if<double>(&binding->second.value)) {
    value = constant({*number});
  } else {
    const auto* curve = std::get_if<std::shared_ptr<const Curve>>(&binding->second.value);
    value = add_vertex({.node = changing_value(binding->second),
                        .arguments = {},
                        .where = parameter.where,
                        .lifetime = curve != nullptr ? (*curve)->silent_from() - sound_start_.start
                                                     : std::numeric_limits<double>::infinity()});
  }
  return value;
}

std::unique_ptr<Node> GraphBuilder::changing_value(const Binding& binding) const {
  if (const auto* live = std::get_if<LiveValue>(&binding.value)) {
    return std::make_unique<ControlNode>(live->control, live->smoothing, sound_start_.rate);
  }
  const auto& curve = std::get<std::shared_ptr<const Curve>>(binding.value);
  return std::make_unique<CurveNode>(curve, sound_start_.start, sound_start_.rate);
}

GraphBuilder::Value GraphBuilder::build_definition(Named& named, const Expression& word, int depth) {
  if (named.is_done) {
    return named.value;
  }
  if (named.is_open) {
    const auto begin = std::ranges::find(open_, word.text);
    return complain(word.where,
                    fmt::format("a cycle: {} needs {}", fmt::join(begin, open_.end(), " needs "), word.text));
  }
  named.is_open = true;
  open_.push_back(named.definition->name);
  named.value = build(named.definition->expression, depth + 1);
  open_.pop_back();
  named.is_done = true;
  return named.value;
}

std::size_t GraphBuilder::constant(std::vector<double> values) {
  std::string key(values.size() * sizeof(double), '\0');
  std::memcpy(key.data(), values.data(), key.size());
  key += " constant";
  const auto [known, is_new] = same_.try_emplace(key, 0);
  if (is_new) {
    known->second = add_value(values.size());
    Graph::Value& value = graph_.values_[known->second];
    value.samples = std::move(values);
    value.is_over = std::ranges::all_of(value.samples, [](double sample) { return sample == 0.0; });
  }
  return known->second;
}

std::size_t GraphBuilder::add_value(std::size_t width) {
  graph_.values_.push_back({.width = width, .samples = {}});
  return graph_.values_.size() - 1;
}

std::size_t GraphBuilder::add_vertex(Graph::Vertex vertex) {
  const std::size_t value = add_value(vertex.width);
  graph_.values_[value].is_constant = false;
  graph_.values_[value].samples.assign(vertex.width * largest_block, 0.0);
  graph_.value_of_node_.push_back(value);
  graph_.nodes_.push_back(std::move(vertex));
  return value;
}

std::string GraphBuilder::kind_of(std::size_t value) const {
  const Graph::Value& found = graph_.values_[value];
  if (found.width == 1) {
    return found.is_constant ? "a number" : "a signal";
  }
  return fmt::format("a vector of {} {}", found.width, found.is_constant ? "numbers" : "signals");
}

GraphBuilder::Value GraphBuilder::complain(const deck::Location& where, const std::string& message) {
  mistakes_.add(where, message);
  return {};
}

std::vector<std::string> GraphBuilder::known_words() const {
  std::vector<std::string> words = {"pi", "rate"};
  for (const Parameter& parameter : tree_.parameters) {
    words.push_back(parameter.name);
  }
  for (const Definition& definition : tree_.definitions) {
    words.push_back(definition.name);
  }
  for (const NodeType& type : node_types()) {
    words.push_back(type.name);
  }
  return words;
}

}  // namespace idiophone::timbre
