#pragma once

namespace idiophone::scene {

/// Limits of time and memory for meshing one body.
struct MeshingLimits {
  double time_limit = 600.0;  ///< s
  double memory_limit = 4e9;  ///< bytes
};

}  // namespace idiophone::scene
