#pragma once
// The materials of a body's regions, and how they lie in it.

#include <Eigen/Core>
#include <span>
#include <vector>

#include "idiophone/scene/body.hpp"
#include "idiophone/scene/material.hpp"

namespace idiophone::solid {

struct OrientedMaterial {
  scene::Material material;
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< of a material that is not isotropic, in the columns
  Eigen::Matrix3d stress = Eigen::Matrix3d::Zero();    ///< of the undeformed body (scene::Prestress), Pa
};

/// Those of a body's regions; of a body without regions, that of all of it. [regions]
/// @param materials  of the deck
[[nodiscard]] std::vector<OrientedMaterial> oriented_materials(const scene::Body& body,
                                                               std::span<const scene::Material> materials);

}  // namespace idiophone::solid
