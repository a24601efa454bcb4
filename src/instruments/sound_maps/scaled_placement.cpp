#include "scaled_placement.hpp"

namespace idiophone::sound_maps {

std::optional<Placement> placement_of(const ScalableModes& now, const ScalableModes& before) {
  constexpr double rounding = 1e-9;
  if (now.mesh == before.mesh) {
    return Placement{};
  }
  if (!now.mesh_shape || !before.mesh_shape || now.mesh_shape->kind != before.mesh_shape->kind) {
    return {};
  }
  const MeshShape &here = *now.mesh_shape, &there = *before.mesh_shape;
  if ((here.pattern - there.pattern).cwiseAbs().maxCoeff() > rounding) {
    return {};
  }
  return Placement{there.middle, here.middle, here.size / there.size, false};
}

}  // namespace idiophone::sound_maps
