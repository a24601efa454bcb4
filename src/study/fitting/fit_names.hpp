#pragma once
// What a fit may be asked to change: constants of a material, and turns of its axes.

#include <string>
#include <vector>

#include "elastic_constants.hpp"

namespace idiophone::fitting {

/// The names of what a fit may change.
/// @param asked  names of constants, turn_x, turn_y or turn_z; "constants" stands for all constants of the material,
///               "turns" for the three turns. Empty: all constants
/// @throws std::runtime_error for a name of nothing that the material has, and for turns of an isotropic one
[[nodiscard]] std::vector<std::string> names_to_fit(const scene::Material& material,
                                                    const std::vector<std::string>& asked);

/// All constants of a material, whether a fit may change them or not, and then the turns that it may change.
/// @param to_fit  names_to_fit()
[[nodiscard]] ElasticConstants constants_and_turns(const scene::Material& material,
                                                   const std::vector<std::string>& to_fit);

}  // namespace idiophone::fitting
