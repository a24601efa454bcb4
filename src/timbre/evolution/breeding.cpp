#include "breeding.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "idiophone/timbre/language/graph.hpp"

namespace idiophone::timbre {

namespace {

/// Calls `visit` for every expression of a tree but the names of nodes. Lists are at most `deepest` deep.
template <class Visitor, class Part>
void visit_all(Part& expression, const Visitor& visit) {
  visit(expression);
  for (std::size_t i = 1; i < expression.items.size(); ++i) {
    visit_all(expression.items[i], visit);
  }
}

std::vector<Expression*> parts_of(Tree& tree) {
  std::vector<Expression*> parts;
  const auto collect = [&](Expression& part) { parts.push_back(&part); };
  for (Definition& definition : tree.definitions) {
    visit_all(definition.expression, collect);
  }
  visit_all(tree.sound, collect);
  return parts;
}

/// The numbers that seed noise: other seeds make the same kind of sound.
std::vector<const Expression*> seeds_of_noise(const std::vector<Expression*>& parts) {
  std::vector<const Expression*> seeds;
  for (const Expression* part : parts) {
    const NodeType* type = part->items.empty() ? nullptr : find_node_type(part->items.front().text);
    if (type == nullptr || type->name == "rvector") {  // whose numbers can be frequencies
      continue;
    }
    for (std::size_t a = 0; a < type->arguments.size() && a + 1 < part->items.size(); ++a) {
      if (type->arguments[a].name == "seed") {
        seeds.push_back(&part->items[a + 1]);
      }
    }
  }
  return seeds;
}

/// The numbers that may change.
std::vector<double*> numbers_of(Tree& tree) {
  std::vector<double*> numbers;
  for (Parameter& parameter : tree.parameters) {
    if (parameter.default_value) {
      numbers.push_back(&*parameter.default_value);
    }
  }
  const std::vector<Expression*> parts = parts_of(tree);
  const std::vector<const Expression*> seeds = seeds_of_noise(parts);
  for (Expression* part : parts) {
    if (part->kind == Expression::Kind::number && std::ranges::find(seeds, part) == seeds.end()) {
      numbers.push_back(&part->number);
    }
  }
  return numbers;
}

void mutate_number(double& number, double spread, Dice& dice) {
  const double step = spread * dice.normal();
  number = number == 0.0 ? step : number * std::exp(step);
}

/// Another kind of node with the same arguments, the same one if there is none.
const NodeType& similar_type(const NodeType& type, Dice& dice) {
  std::vector<const NodeType*> similar;
  for (const NodeType& other : node_types()) {
    const auto same_kind = [](const Argument& a, const Argument& b) { return a.kind == b.kind; };
    if (other.repeats == type.repeats && !type.arguments.empty() &&
        std::ranges::equal(other.arguments, type.arguments, same_kind)) {
      similar.push_back(&other);
    }
  }
  return similar.empty() ? type : *similar[dice.below(similar.size())];
}

}  // namespace

void mutate_constants(Tree& tree, double spread, Dice& dice) {
  const std::vector<double*> numbers = numbers_of(tree);
  if (numbers.empty()) {
    return;
  }
  constexpr double share = 0.35;
  for (double* number : numbers) {
    if (dice.uniform() < share) {
      mutate_number(*number, spread, dice);
    }
  }
  mutate_number(*numbers[dice.below(numbers.size())], spread, dice);
}

void mutate_by_difference(Tree& tree, const Tree& from, const Tree& to, Dice& dice) {
  Tree first = from, second = to;
  const std::vector<double*> numbers = numbers_of(tree), starts = numbers_of(first), ends = numbers_of(second);
  if (numbers.size() != starts.size() || numbers.size() != ends.size()) {
    return;
  }
  const double share = 0.4 + 0.6 * dice.uniform();
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const double ratio = *ends[i] / *starts[i];
    if (ratio > 0.0 && std::isfinite(ratio) && dice.uniform() < 0.8) {
      *numbers[i] *= std::pow(ratio, share);
    }
  }
}

void mutate_node(Tree& tree, Dice& dice) {
  std::vector<Expression*> lists;
  for (Expression* part : parts_of(tree)) {
    if (part->items.size() > 1) {
      lists.push_back(part);
    }
  }
  if (lists.empty()) {
    return;
  }
  Expression& chosen = *lists[dice.below(lists.size())];
  if (dice.uniform() < 0.3) {
    Expression argument = chosen.items[1 + dice.below(chosen.items.size() - 1)];
    chosen = std::move(argument);
  } else if (const NodeType* type = find_node_type(chosen.items.front().text)) {
    chosen.items.front().text = similar_type(*type, dice).name;
  }
}

void cross(Tree& tree, const Tree& other, Dice& dice) {
  Tree donor = other;
  const std::vector<Expression*> places = parts_of(tree);
  const std::vector<Expression*> gifts = parts_of(donor);
  *places[dice.below(places.size())] = *gifts[dice.below(gifts.size())];
}

std::size_t size_of(const Tree& tree) {
  std::size_t size = 0;
  const auto count = [&](const Expression& /*part*/) { ++size; };
  for (const Definition& definition : tree.definitions) {
    visit_all(definition.expression, count);
  }
  visit_all(tree.sound, count);
  return size;
}

bool is_valid(const Tree& tree, int rate, std::size_t most_nodes) {
  if (size_of(tree) > most_nodes) {
    return false;
  }
  try {
    std::array<double, 256> samples{};
    Graph(tree, {}, {.rate = rate}).render(samples);
    return true;
  } catch (const std::runtime_error&) {
    return false;
  }
}

}  // namespace idiophone::timbre
