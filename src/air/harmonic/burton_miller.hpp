#pragma once
// The linear equations of the exterior Helmholtz problem: the boundary integral equation and its normal derivative,
// combined (Burton and Miller 1971), in Galerkin's form. With S, K, K' and H, the single layer, double layer, its
// adjoint and the hypersingular operator, q = dp/dn = -i k z v, and the incident pressure p_i:
//   (K - 1/2) p + alpha H p = S q + alpha (K' + 1/2) q - p_i - alpha dp_i/dn

#include <Eigen/Core>
#include <span>
#include <vector>

#include "galerkin.hpp"
#include "idiophone/air/harmonic/boundary_elements.hpp"

namespace idiophone::harmonic {

[[nodiscard]] std::vector<Panel> panels_of(const Boundary& boundary);

/// What the full and the compressed form of the equations have in common.
struct Equations {
  const Boundary& boundary;
  const std::vector<Panel>& panels;
  double wave_number;
  Complex coupling;  ///< alpha = -i/max(k, 1/L), 4 pi L^2 the area of the boundary. Without a lower bound of k, the
                     ///< equation would lose its first part at low frequencies.
  Eigen::MatrixXcd slopes;  ///< q, [3 x panels][motions]

  Equations(const Boundary& boundary, const std::vector<Panel>& panels, const QuietAir& air, double wave_number,
            std::span<const std::vector<Complex>> velocities);

  [[nodiscard]] Eigen::Index vertices() const { return static_cast<Eigen::Index>(boundary.vertices.size()); }

  /// Double integrals of K + alpha H over an outer panel's shape functions (rows) and an inner one's (columns). H is
  /// integrated by parts, so that it has no singularity beyond that of S (Maue 1949):
  ///   <N_a, H N_b> = integral of G (k^2 n.n' N_a N_b - curl N_a . curl N_b),  curl N = n x grad N
  [[nodiscard]] Eigen::Matrix3cd pressure_block(const Panel& outer, const Panel& inner, const PanelPair& pair) const;

  /// Adds the parts without integral operators to a full or sparse matrix, [vertices x vertices], and to the right
  /// sides, [vertices x motions].
  template <class Matrix>
  void add_mass(Matrix& matrix, Eigen::MatrixXcd& right_sides) const {
    for (std::size_t t = 0; t < panels.size(); ++t) {
      const Eigen::Matrix3d mass = panel_mass(panels[t]);
      for (std::size_t a = 0; a < 3; ++a) {
        const Index row = boundary.triangles[t].at(a);
        for (std::size_t b = 0; b < 3; ++b) {
          matrix.coeffRef(row, boundary.triangles[t].at(b)) -= 0.5 * mass(a, b);
          right_sides.row(row) += 0.5 * coupling * mass(a, b) * slopes.row(3 * t + b);
        }
      }
    }
  }

  /// Adds the pressure and the normal derivative of point sources, and of their images in the floor.
  void add_incident(std::span<const PointSource> sources, Eigen::MatrixXcd& right_sides) const;
};

struct LinearSystem {
  Eigen::MatrixXcd matrix;       ///< [vertices x vertices]
  Eigen::MatrixXcd right_sides;  ///< [vertices x motions]
};

/// The full matrix.
[[nodiscard]] LinearSystem burton_miller(const Equations& equations, std::span<const PointSource> sources);

}  // namespace idiophone::harmonic
