#pragma once
// Iterative solution of Burton and Miller's equations.

#include "burton_miller.hpp"

namespace idiophone::harmonic {

/// By PETSc's restarted GMRES on a CompressedSystem, until the residual is 1e-5 of the right side. Options of PETSc
/// with the prefix `radiation_` change it. Each rank solves for itself.
/// @return [vertices x motions]
/// @throws std::runtime_error if it does not converge, or the surface is too large
[[nodiscard]] Eigen::MatrixXcd solve_iteratively(const Equations& equations, std::span<const PointSource> sources,
                                                 double longest_edge);

}  // namespace idiophone::harmonic
