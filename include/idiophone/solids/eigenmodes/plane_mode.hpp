#pragma once
// Modes of bodies in a plane, which move across it.

#include <optional>
#include <vector>

namespace idiophone::eigenmodes {

struct PlaneMode {
  double frequency = 0.0;     ///< Hz
  std::vector<double> shape;  ///< [nodes of the mesh] displacement across the plane for unit modal mass, 1/sqrt(kg)
};

/// Which modes are wanted.
struct WantedModes {
  int count = 1;                ///< the lowest, where `up_to` is not given
  std::optional<double> up_to;  ///< all up to this frequency, Hz
};

}  // namespace idiophone::eigenmodes
