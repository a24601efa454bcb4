#pragma once
// Modes of a membrane that is held at its rim: -div(T grad w) = sigma (2 pi f)^2 w, with quadratic triangles.

#include <functional>
#include <vector>

#include "idiophone/solids/eigenmodes/plane_mode.hpp"
#include "idiophone/solids/mesh/plane_mesh.hpp"

namespace idiophone::eigenmodes {

/// A quantity that varies with the place, by x and y (m).
using PlaneField = std::function<double(double x, double y)>;

struct Membrane {
  PlaneField tension;  ///< T, N/m, above zero
  PlaneField density;  ///< sigma, kg/m2, above zero
};

/// The lowest modes, ascending, on this rank alone.
/// @throws std::runtime_error where there are none or not so many, or the solver fails
[[nodiscard]] std::vector<PlaneMode> membrane_modes(const mesh::PlaneMesh& mesh, const Membrane& membrane,
                                                    const WantedModes& wanted);

}  // namespace idiophone::eigenmodes
