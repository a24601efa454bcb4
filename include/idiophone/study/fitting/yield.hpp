#pragma once
// The yield of a tuned shape: the share of bodies that are in tune although wood and cuts differ (docs/use/tune.md).

#include <optional>
#include <string>
#include <vector>

#include "idiophone/solids/eigenmodes/eigenmodes.hpp"
#include "idiophone/study/fitting/target.hpp"
#include "idiophone/study/fitting/variables.hpp"
#include "idiophone/study/fitting/watch.hpp"

namespace idiophone::fitting {

struct YieldOptions {
  std::vector<int> modes;  ///< numbers from 1 on of the tuned modes on the mean body; as many as the target's values
  double within = 5.0;     ///< cents from the target, at which a mode is still in tune
  std::string body = {};   ///< empty for the first
  eigenmodes::MassMatrix mass = eigenmodes::MassMatrix::lumped;
  Watch watch = {};  ///< none: all bodies are solved
};

struct Yield {
  double share = 0.0;                             ///< of the bodies whose modes are all in tune, 0 to 1
  std::vector<double> deviations = {};            ///< [modes] standard deviation of the error, cents
  std::vector<std::vector<double>> effects = {};  ///< [modes][scatters] cents for one standard deviation of the number
};

/// Solves for the mean body, and for two bodies of each number: one standard deviation above and below. The error of
/// each mode is the sum of a parabola through these three for each number. 100 000 bodies are drawn, always the same
/// ones, with numbers that are independent and normal. Errors of ratios are those above the first mode. On this rank
/// alone.
/// @param scene_of  for values of the numbers that scatter
/// @return none if the watch ended the work
/// @throws std::runtime_error if a mode can't be recognised; what `scene_of`, mesh::read_mesh() and
///         eigenmodes::find_modes() throw
[[nodiscard]] std::optional<Yield> yield_of(const SceneOf& scene_of, const std::vector<Scatter>& scatters,
                                            const Target& target, const YieldOptions& options);

}  // namespace idiophone::fitting
