#include "placement.hpp"

#include <cmath>

namespace idiophone::sound_maps {

std::optional<Placement> placement_of(const ScalableModes& now, const ScalableModes& before) {
  constexpr double rounding = 1e-9;  // relative
  if (now.mesh == before.mesh) {
    return Placement{};
  }
  if (!now.mesh_shape || !before.mesh_shape || now.mesh_shape->kind != before.mesh_shape->kind) {
    return {};
  }
  const MeshShape &here = *now.mesh_shape, &there = *before.mesh_shape;
  const double square = here.moments.trace() / there.moments.trace();
  const Placement placement{there.middle, here.middle, std::sqrt(square), false};
  const double size = std::sqrt(here.moments.trace());
  const bool is_similar = (here.moments - square * there.moments).norm() <= rounding * size * size &&
                          (here.held - placement.size * there.held).norm() <= rounding * size;
  return is_similar ? std::optional(placement) : std::nullopt;
}

}  // namespace idiophone::sound_maps
