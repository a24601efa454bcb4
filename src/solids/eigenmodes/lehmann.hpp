#pragma once
// Lower bounds of eigenvalues by Lehmann and Goerisch.

#include <Eigen/Core>

namespace idiophone::eigenmodes {

/// How far approximate stresses s_i are from those of displacements u_i with Rayleigh quotients v_i.
struct StressDefects {
  Eigen::MatrixXd energy;    ///< [modes x modes] integrals of (s_i - C e(u_i)) : C^-1 (s_j - C e(u_j)), J
  Eigen::MatrixXd equation;  ///< [modes x modes] integrals of r_i r_j/density, r_i = div s_i + density v_i u_i, J/s2
};

/// Lower bounds of the lowest eigenvalues by the theorem of Lehmann and Goerisch, with the shift g that serves each
/// best (docs/method/bounds.md).
/// @param values      v_i, ascending, (rad/s)^2; u_i are orthogonal, of unit modal mass, and so are their strains
/// @param separation  above all values and not above the next eigenvalue of the solid, (rad/s)^2
/// @return [modes] ascending, (rad/s)^2; 0 where nothing better is known
[[nodiscard]] Eigen::VectorXd lower_bounds(const Eigen::VectorXd& values, const StressDefects& defects,
                                           double separation);

}  // namespace idiophone::eigenmodes
