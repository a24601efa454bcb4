// The calls of nodes in a tree: their arguments are checked, and equal calls become one node.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "graph_builder.hpp"
#include "idiophone/foundation/deck/suggestion.hpp"

namespace idiophone::timbre {

namespace {

/// What an error says after the place that it names first.
std::string without_place(const std::string& said, const deck::Location& where) {
  const std::string place = deck::to_string(where) + ": ";
  return said.starts_with(place) ? said.substr(place.size()) : said;
}

}  // namespace

GraphBuilder::Value GraphBuilder::build_call(const Expression& call, int depth) {
  if (call.items.empty() || call.items.front().kind != Expression::Kind::word) {
    return complain(call.where, "a list begins with the name of a node");
  }
  const Expression& name = call.items.front();
  const NodeType* type = find_node_type(name.text);
  if (type == nullptr) {
    std::vector<std::string> names;
    for (const NodeType& known : node_types()) {
      names.push_back(known.name);
    }
    return complain(name.where, fmt::format("there is no node '{}'{}", name.text, deck::suggestion(name.text, names)));
  }
  return build_node(*type, call.where, std::span(call.items).subspan(1), depth);
}

bool GraphBuilder::check_count(const NodeType& type, const deck::Location& where, std::size_t count) {
  const auto needed = static_cast<std::size_t>(
      std::ranges::count_if(type.arguments, [](const Argument& argument) { return !argument.default_value; }));
  if (count < needed || (count > type.arguments.size() && !type.repeats)) {
    complain(where, fmt::format("found {} argument{}; write {}", count, count == 1 ? "" : "s", type.usage()));
    return false;
  }
  return true;
}

bool GraphBuilder::take_argument(const NodeType& type, const Argument& argument, const Expression& expression,
                                 Call& call, std::vector<std::size_t>& values, int depth) {
  using Kind = Argument::Kind;
  std::string& text = call.texts.emplace_back();
  std::vector<double>& known = call.constants.emplace_back();
  const auto refuse = [&](const std::string& expected) {
    complain(expression.where,
             fmt::format("{} of ({} ...) is {}, found {}", argument.name, type.name, expected, describe(expression)));
    return false;
  };
  if (argument.kind == Kind::word || argument.kind == Kind::text) {
    const bool is_word = argument.kind == Kind::word;
    text = expression.text;
    return expression.kind == (is_word ? Expression::Kind::word : Expression::Kind::text) ||
           refuse(is_word ? "a word" : "a text in quotes");
  }
  const Value value = build(expression, depth + 1);
  if (!value) {
    return false;
  }
  values.push_back(*value);
  const Graph::Value& found = graph_.values_[*value];
  known = found.is_constant ? found.samples : std::vector<double>{};
  if (argument.kind != Kind::signal && (!found.is_constant || (argument.kind == Kind::number && found.width > 1))) {
    complain(expression.where,
             fmt::format("{} of ({} ...) is a {} that does not change with time, found {}", argument.name, type.name,
                         argument.kind == Kind::number ? "number" : "vector", kind_of(*value)));
    return false;
  }
  if (argument.kind == Kind::signal && found.width > 1 && call.width > 1 && found.width != call.width) {
    complain(call.where,
             fmt::format("({} ...) has arguments of {} and of {} components", type.name, call.width, found.width));
    return false;
  }
  call.width = argument.kind == Kind::signal ? std::max(call.width, found.width) : call.width;
  return true;
}

GraphBuilder::Value GraphBuilder::build_node(const NodeType& type, const deck::Location& where,
                                             std::span<const Expression> arguments, int depth) {
  if (!check_count(type, where, arguments.size())) {
    return {};
  }
  Call call{.sound_start = sound_start_, .where = where, .folder = tree_.file.parent_path()};
  std::vector<std::size_t> values;
  bool good = true;
  for (std::size_t a = 0; a < std::max(arguments.size(), type.arguments.size()); ++a) {
    const Argument& argument = type.arguments[std::min(a, type.arguments.size() - 1)];
    if (a < arguments.size()) {
      good &= take_argument(type, argument, arguments[a], call, values, depth);
    } else {
      call.texts.emplace_back();
      call.constants.push_back({*argument.default_value});
      values.push_back(constant({*argument.default_value}));
    }
  }
  if (!good) {
    return {};
  }
  return make(type, call, std::move(values));
}

GraphBuilder::Value GraphBuilder::make(const NodeType& type, const Call& call, std::vector<std::size_t> values) {
  std::string key = fmt::format("{} {} {}", type.name, fmt::join(values, ","), fmt::join(call.texts, "\n"));
  if (const auto same = same_.find(key); same != same_.end()) {
    return same->second;
  }
  Graph::Vertex vertex;
  try {
    vertex = {.node = type.make(call),
              .arguments = std::move(values),
              .width = type.width(call),
              .type = &type,
              .where = call.where,
              .texts = call.texts,
              .lifetime = type.lifetime(call),
              .memory = type.memory(call)};
  } catch (const deck::DeckError& error) {  // the tree may have other mistakes
    return complain(call.where, without_place(error.what(), call.where));
  }
  const auto is_constant = [&](std::size_t value) { return graph_.values_[value].is_constant; };
  std::size_t result = 0;
  if (type.is_timeless && std::ranges::all_of(vertex.arguments, is_constant)) {
    std::vector<Input> inputs;
    for (const std::size_t argument : vertex.arguments) {
      const Graph::Value& value = graph_.values_[argument];
      inputs.push_back({value.samples.data(), 0, value.width == 1 ? 0U : 1U});
    }
    std::vector<double> samples(vertex.width);
    vertex.node->render({0, 1, vertex.width}, inputs, samples);
    if (!std::ranges::all_of(samples, [](double sample) { return std::isfinite(sample); })) {
      return complain(call.where, fmt::format("({} ...) of these numbers is not finite", type.name));
    }
    result = constant(std::move(samples));
  } else {
    result = add_vertex(std::move(vertex));
  }
  same_[std::move(key)] = result;
  return result;
}

}  // namespace idiophone::timbre
