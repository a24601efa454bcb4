#pragma once
// Joints of a deck: what ties surfaces of bodies together.

#include <array>
#include <optional>
#include <string>

#include "idiophone/foundation/deck/location.hpp"

namespace idiophone::scene {

/// A surface that a joint holds.
struct JoinedSurface {
  std::size_t body = 0;  ///< index into Scene::bodies
  std::string group;     ///< physical group of surfaces of the body's mesh
  deck::Location where;
};

/// Stress over stretch of a thin elastic layer, Pa/m; both above 0.
struct LayerStiffness {
  double normal = 0.0;      ///< pressure or pull over the change of its thickness
  double tangential = 0.0;  ///< shear stress over the shift of its two sides
};

/// A thin elastic layer without mass between two surfaces.
struct Joint {
  std::string name;
  std::array<JoinedSurface, 2> surfaces;
  std::optional<LayerStiffness> stiffness;  ///< none: rigid, with a stiffness that the program chooses
  double damping = 0.0;                     ///< relaxation time: stress = stiffness (stretch + damping * its rate), s
  std::optional<double> reach;  ///< up to this distance the surfaces are joined, m; chosen by the program if omitted
  deck::Location where;
};

}  // namespace idiophone::scene
