#include "fit_names.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numbers>
#include <stdexcept>

#include "idiophone/foundation/deck/suggestion.hpp"

namespace idiophone::fitting {

namespace {

const std::vector<std::string> turn_names = {"turn_x", "turn_y", "turn_z"};

bool has(const std::vector<std::string>& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

/// What a word of a user stands for.
/// @throws as names_to_fit()
std::vector<std::string> names_by(const std::string& word, const scene::Material& material,
                                  const std::vector<std::string>& constants) {
  if (word == "constants") {
    return constants;
  }
  const bool is_turn = word == "turns" || has(turn_names, word);
  if (is_turn && material.is_isotropic()) {
    throw std::runtime_error(fmt::format(
        "{}: material {} is the same in all directions, so a turn of its axes changes nothing", word, material.name));
  }
  if (word == "turns") {
    return turn_names;
  }
  if (!is_turn && !has(constants, word)) {
    std::vector<std::string> known = constants;
    known.emplace_back("constants");
    if (!material.is_isotropic()) {
      known.insert(known.end(), turn_names.begin(), turn_names.end());
      known.emplace_back("turns");
    }
    throw std::runtime_error(fmt::format("material {} has no elastic constant '{}'{}; to be fitted are: {}",
                                         material.name, word, deck::suggestion(word, known), fmt::join(known, ", ")));
  }
  return {word};
}

}  // namespace

std::vector<std::string> names_to_fit(const scene::Material& material, const std::vector<std::string>& asked) {
  std::vector<std::string> constants;
  std::ranges::transform(elastic_constants(material), std::back_inserter(constants), &ElasticConstant::name);
  std::vector<std::string> names;
  for (const std::string& word : asked) {
    std::ranges::copy(names_by(word, material, constants), std::back_inserter(names));
  }
  return asked.empty() ? constants : names;
}

ElasticConstants constants_and_turns(const scene::Material& material, const std::vector<std::string>& to_fit) {
  ElasticConstants all = elastic_constants(material);
  for (int axis = 0; axis < 3; ++axis) {
    if (const std::string& name = turn_names[static_cast<std::size_t>(axis)]; has(to_fit, name)) {
      all.push_back({.name = name,
                     .kind = ConstantKind::turn,
                     .in = [axis](TurnedMaterial& m) -> double& { return m.turns[axis]; },
                     .unit = [](const scene::Material&) { return 180 / std::numbers::pi; }});
    }
  }
  return all;
}

}  // namespace idiophone::fitting
