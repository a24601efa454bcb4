#pragma once
// Modes of a thin plate (Kirchhoff): D biharmonic w - T laplacian w = sigma (2 pi f)^2 w, with triangles of Hsieh,
// Clough and Tocher.

#include <vector>

#include "idiophone/solids/eigenmodes/plane_mode.hpp"
#include "idiophone/solids/mesh/plane_mesh.hpp"

namespace idiophone::eigenmodes {

/// What holds a side of a plate.
enum class PlateEdge {
  free,       ///< nothing
  supported,  ///< it can't move, but turn
  clamped     ///< it can neither move nor turn
};

struct Plate {
  double stiffness = 0.0;                     ///< D = E h^3/(12 (1 - nu^2)), N m
  double poisson = 0.0;                       ///< nu, 1; it matters where edges are free, or supported and curved
  double tension = 0.0;                       ///< T, N/m
  double density = 0.0;                       ///< sigma, kg/m2
  std::vector<std::vector<PlateEdge>> edges;  ///< [contours of the region][sides of the contour]
};

/// The lowest modes beside the rigid motions, ascending, on this rank alone. Circles are taken as polygons: of the
/// same area where they are free or clamped, and with the corners on the circle where they are supported. There, the
/// plate is held at the corners alone, because supported polygons tend to another limit than the circle (Babuska 1961).
/// @param mesh  of the region
/// @throws std::runtime_error where there are none or not so many, or the solver fails
[[nodiscard]] std::vector<PlaneMode> plate_modes(const mesh::PlaneRegion& region, const mesh::PlaneMesh& mesh,
                                                 const Plate& plate, const WantedModes& wanted);

}  // namespace idiophone::eigenmodes
