#pragma once
// A material whose axes are turned in its body.

#include <Eigen/Core>
#include <utility>

#include "idiophone/scene/material.hpp"

namespace idiophone::fitting {

/// A material, and how its axes are turned from those of the deck. A specimen is never cut exactly along the axes of
/// its material.
struct TurnedMaterial : scene::Material {
  TurnedMaterial() = default;
  /// With the axes of the deck. Wherever a fit takes a turned material, one that is not turned will do.
  TurnedMaterial(scene::Material material) : scene::Material(std::move(material)) {}

  Vector3 turns = Vector3::Zero();  ///< degrees: about the material's own x, then its new y, then its new z

  /// The rotation by these turns; the deck's axes times it are the axes of the material.
  [[nodiscard]] Eigen::Matrix3d turn() const;
};

/// The turns of a rotation, degrees; the second is from -90 to 90.
[[nodiscard]] Vector3 turns_of(const Eigen::Matrix3d& rotation);

}  // namespace idiophone::fitting
