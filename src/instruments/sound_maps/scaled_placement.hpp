#pragma once
// Bodies that have grown and moved since their map was made.

#include <optional>

#include "idiophone/instruments/sound_maps/sound_map.hpp"

namespace idiophone::sound_maps {

/// Where a point that goes with the body is now.
struct Placement {
  Vector3 before = Vector3::Zero();  ///< the middle of the mesh, m
  Vector3 now = Vector3::Zero();     ///< likewise
  double size = 1.0;                 ///< factor
  bool stays = true;                 ///< nothing has moved

  [[nodiscard]] Vector3 of(const Vector3& point) const { return stays ? point : now + size * (point - before); }
};

/// How the mesh lies now; none where it is another one, or an older map does not tell.
[[nodiscard]] std::optional<Placement> placement_of(const ScalableModes& now, const ScalableModes& before);

}  // namespace idiophone::sound_maps
