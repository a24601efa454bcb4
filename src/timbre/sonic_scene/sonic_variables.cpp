#include "sonic_variables.hpp"

#include <algorithm>
#include <cmath>

namespace idiophone::timbre {

using namespace deck;  // values, keys and sections

namespace {

/// The words of interpolation.
const Choices<Interpolation>& interpolations() {
  static const Choices<Interpolation> words{
      {{"linear", Interpolation::linear}, {"cubic", Interpolation::cubic}, {"hold", Interpolation::hold}}};
  return words;
}

bool read_keyframes(Section& section, Keyframes& keyframes) {
  section.optional("interpolation", keyframes.interpolation, interpolations());
  const bool good = section.required("keys", keyframes.keys, NumberPair{});
  if (good && keyframes.keys.empty()) {
    return section.mistakes().add(*section.find("keys"), "is empty; it needs at least one row of time and value");
  }
  const auto ascends = [](const auto& a, const auto& b) { return a[0] >= b[0]; };
  if (good && std::ranges::adjacent_find(keyframes.keys, ascends) != keyframes.keys.end()) {
    return section.mistakes().add(*section.find("keys"), "times must ascend");
  }
  return good;
}

void read_event_variable(Section& section, EventVariable& event) {
  const Choices<EventVariable::Quantity> quantities{
      {{"force", EventVariable::Quantity::force}, {"impulse", EventVariable::Quantity::impulse}}};
  section.required("event", event.quantity, quantities);
  read_mapping(section, event.mapping);
}

bool read_variable_name(const Node& node, Mistakes& mistakes, Variable& variable, const VariableRules& rules) {
  const auto found = std::ranges::find(rules.named, node.text, &NamedVariable::name);
  if (found == rules.named.end()) {
    std::vector<std::string> names;
    for (const NamedVariable& named : rules.named) {
      names.push_back(named.name);
    }
    return mistakes.add(node, "there is no variable " + describe(node) + suggestion(node.text, names));
  }
  variable = found->variable;
  return true;
}

}  // namespace

bool read(const Node& node, Mistakes& mistakes, std::array<double, 2>& pair, const NumberPair& /*rule*/) {
  if (node.kind != Node::Kind::list || node.children.size() != 2) {
    return mistakes.add(node, "expected a list of 2 numbers, found " + describe(node));
  }
  return read(node.children[0], mistakes, pair[0], Range{}) && read(node.children[1], mistakes, pair[1], Range{});
}

void read_mapping(Section& section, Mapping& mapping) {
  section.optional("scale", mapping.scale, Range{});
  section.optional("offset", mapping.offset, Range{});
  section.optional("curve", mapping.curve, Range{.above = 0.0, .at_most = 100.0});
  if (section.optional("range", mapping.range, NumberPair{}) && mapping.range &&
      (*mapping.range)[0] > (*mapping.range)[1]) {
    section.mistakes().add(*section.find("range"), "the first number is the lower one");
  }
}

void read_channel(Section& section, MotionVariable& motion) {
  motion.where = section.node().where;
  if (section.required("channel", motion.channel)) {
    motion.where = section.find("channel")->where;
  }
  if (section.find("column") != nullptr) {
    section.required("column", motion.column);
  }
  section.optional("interpolation", motion.interpolation, interpolations());
  section.optional("derivative", motion.derivative, Choices<bool>{{{"true", true}, {"false", false}}});
}

bool read(const Node& node, Mistakes& mistakes, NamedVariable& named, const VariableRules& rules) {
  named.where = node.where;
  if (node.kind == Node::Kind::scalar && !node.text.empty() && std::isalpha(node.text.front()) != 0) {
    return read_variable_name(node, mistakes, named.variable, rules);
  }
  if (node.kind != Node::Kind::map) {
    double number = 0.0;
    const bool good = read(node, mistakes, number, Range{});
    named.variable = number;
    return good;
  }
  Section section(node, mistakes);
  if (section.find("keys") != nullptr) {
    read_keyframes(section, named.variable.emplace<Keyframes>());
  } else if (section.find("event") != nullptr) {
    read_event_variable(section, named.variable.emplace<EventVariable>());
  } else {
    auto& motion = named.variable.emplace<MotionVariable>();
    read_channel(section, motion);
    read_mapping(section, motion.mapping);
  }
  return section.finish();
}

double Mapping::operator()(double number) const {
  const double value = offset + scale * std::copysign(std::pow(std::abs(number), curve), number);
  return range ? std::clamp(value, (*range)[0], (*range)[1]) : value;
}

}  // namespace idiophone::timbre
