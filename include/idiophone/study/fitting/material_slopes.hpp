#pragma once
// How the constants of a body's material move its modes.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "idiophone/scene/material.hpp"
#include "idiophone/scene/solids.hpp"
#include "idiophone/solids/eigenmodes/eigenmodes.hpp"
#include "idiophone/solids/mesh/part.hpp"

namespace idiophone::fitting {

/// The unknowns are logarithms of moduli, and ratios, as `identify` fits them.
struct MaterialSlopes {
  std::vector<std::string> names;  ///< [constants]; none of a body of several materials or with a prestress
  Eigen::VectorXd deviations;      ///< [constants] standard deviations of the unknowns before anything is measured
  Eigen::MatrixXd cents;           ///< [modes x constants] for each 1 of an unknown (Hellmann and Feynman)
};

/// @param solids  of one body
/// @param part    of the body, all of it on this rank
/// @param modes   ascending, with shapes in the order of the part's nodes
[[nodiscard]] MaterialSlopes material_slopes(const scene::Solids& solids, const mesh::Part& part,
                                             const std::vector<eigenmodes::Mode>& modes);

/// As much of some amounts as leaves the material stable: the greatest tenth of all of them at which every strain costs
/// energy. Nothing is left of them where the material itself is not stable. [constants]
[[nodiscard]] Eigen::VectorXd stable_part(const scene::Material& material, const Eigen::VectorXd& amounts);

/// The material with its unknowns moved by some amounts. [constants]
[[nodiscard]] scene::Material moved(const scene::Material& material, const Eigen::VectorXd& amounts);

}  // namespace idiophone::fitting
