#pragma once
// Numbers of a deck that may be changed, or that differ from body to body, as a user writes them:
// "bodies.bar.parameters.depth=0.01:0.02", "materials.rosewood.density=4%".

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "idiophone/scene/scene.hpp"

namespace idiophone::fitting {

/// A number of the deck that may be changed, in its own unit.
struct Variable {
  std::string key;  ///< path in the deck: "bodies.bar.parameters.depth"
  double lower = 0.0;
  double upper = 0.0;
  double start = 0.0;
};

/// A number of the deck that differs from body to body with a normal distribution, in its own unit.
struct Scatter {
  std::string key;  ///< path in the deck
  double mean = 0.0;
  double deviation = 0.0;  ///< standard deviation, above 0
};

/// The scene for values of numbers of its deck.
using SceneOf = std::function<scene::Scene(const std::vector<double>& values)>;

/// Reads KEY=LOWEST:HIGHEST of each text. The deck, with its overrides, has the start.
/// @throws std::runtime_error for another text, a start outside its bounds and a key that is given twice; what
///         number_at() throws
[[nodiscard]] std::vector<Variable> read_variables(const std::vector<std::string>& texts,
                                                   const std::filesystem::path& deck,
                                                   const std::vector<std::string>& overrides);

/// Reads KEY=DEVIATION of each text, in the number's unit or in percent of it. The deck, with its overrides, has the
/// mean.
/// @throws std::runtime_error for another text, a deviation that is not above 0 and a key that is given twice; what
///         number_at() throws
[[nodiscard]] std::vector<Scatter> read_scatters(const std::vector<std::string>& texts,
                                                 const std::filesystem::path& deck,
                                                 const std::vector<std::string>& overrides);

}  // namespace idiophone::fitting
