#pragma once

namespace idiophone::scene {

/// What gmsh may use to make one mesh.
struct MeshingLimits {
  double time_limit = 600.0;  ///< s
  double memory_limit = 4e9;  ///< bytes
};

}  // namespace idiophone::scene
