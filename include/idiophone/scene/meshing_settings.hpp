#pragma once

#include <optional>

namespace idiophone::scene {

/// What is done to a surface of triangles before it is filled.
enum class Repair {
  none,
  wrap  ///< a closed surface around it takes its place
};

/// How the mesh of one body is made.
struct MeshingSettings {
  double time_limit = 600.0;  ///< s
  double memory_limit = 4e9;  ///< bytes
  Repair repair = Repair::none;
  std::optional<double> gap;  ///< wrap closes openings up to this width, m; none: the program chooses it
};

}  // namespace idiophone::scene
