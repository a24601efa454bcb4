#pragma once
// The linear equations of the exterior Helmholtz problem: the boundary integral equation and its normal derivative,
// combined (Burton and Miller 1971), in Galerkin's form.

#include <Eigen/Core>
#include <span>
#include <vector>

#include "galerkin.hpp"
#include "idiophone/radiation/boundary_elements.hpp"

namespace idiophone::radiation {

struct LinearSystem {
  Eigen::MatrixXcd matrix;       ///< [vertices x vertices]
  Eigen::MatrixXcd right_sides;  ///< [vertices x motions]
};

[[nodiscard]] std::vector<Panel> panels_of(const Boundary& boundary);

/// With S, K, K' and H, the single layer, double layer, its adjoint and the hypersingular operator, q = -i k z v, and
/// the incident pressure p_i:
///   (K - 1/2) p + alpha H p = S q + alpha (K' + 1/2) q - p_i - alpha dp_i/dn
/// alpha = -i/max(k, 1/L), 4 pi L^2 the area of the boundary: without a lower bound of k, the equation would lose its
/// first part at low frequencies. H is integrated by parts, so that it has no singularity beyond that of S (Maue 1949):
///   <N_a, H N_b> = integral of G (k^2 n.n' N_a N_b - curl N_a . curl N_b),  curl N = n x grad N
[[nodiscard]] LinearSystem burton_miller(const Boundary& boundary, const std::vector<Panel>& panels,
                                         const QuietAir& air, double wave_number,
                                         std::span<const std::vector<Complex>> velocities,
                                         std::span<const PointSource> sources);

}  // namespace idiophone::radiation
