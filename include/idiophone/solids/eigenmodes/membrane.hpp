#pragma once
// Modes of a membrane that is held at its rim: -T laplacian w = sigma (2 pi f)^2 w, with quadratic triangles.

#include <optional>
#include <vector>

#include "idiophone/solids/mesh/plane_mesh.hpp"

namespace idiophone::eigenmodes {

struct Membrane {
  double tension = 0.0;  ///< T, N/m
  double density = 0.0;  ///< sigma, kg/m2
};

struct MembraneMode {
  double frequency = 0.0;     ///< Hz
  std::vector<double> shape;  ///< [nodes of the mesh] displacement across the plane for unit modal mass, 1/sqrt(kg)
};

/// The lowest modes, ascending, on this rank alone.
/// @param count  how many, where `up_to` is not given
/// @param up_to  all modes up to this frequency, Hz
/// @throws std::runtime_error where there are none or not so many, or the solver fails
[[nodiscard]] std::vector<MembraneMode> membrane_modes(const mesh::PlaneMesh& mesh, const Membrane& membrane, int count,
                                                       std::optional<double> up_to);

}  // namespace idiophone::eigenmodes
