#pragma once
// The emission of a surface at one audio sample: all that radiation models know of the motion.

#include <array>
#include <vector>

namespace idiophone::surface {

/// All of one rank's triangles at one audio sample, as arrays over triangles.
struct Emission {
  std::vector<double> pressure;               ///< filtered pressure (p tilde of eq. 9), Pa
  std::vector<double> surface_pressure;       ///< of the air at the surface (see SurfacePressure), Pa
  std::vector<double> pressure_gradient;      ///< outward normal derivative of the air's pressure, Pa/m; of a box in
                                              ///< the air only, and empty otherwise
  std::vector<double> area;                   ///< eq. 3, m2
  std::array<std::vector<double>, 3> normal;  ///< outward unit normal, eq. 4
  std::array<std::vector<double>, 3> centre;  ///< m

  /// Makes room for so many triangles.
  void resize(std::size_t triangles) {
    pressure.resize(triangles);
    surface_pressure.resize(triangles);
    area.resize(triangles);
    for (auto* components : {&normal, &centre}) {
      for (auto& component : *components) {
        component.resize(triangles);
      }
    }
  }
};

}  // namespace idiophone::surface
