#pragma once
// Stresses of modes that are in equilibrium as far as elements of one order more allow it.

#include "element_fields.hpp"
#include "idiophone/foundation/dense/dense.hpp"
#include "lehmann.hpp"
#include "stress_space.hpp"

namespace idiophone::eigenmodes {

/// An elastic solid on a mesh of hexahedra, and displacements of it.
struct ElasticModes {
  const mesh::Mesh& mesh;
  dense::Matrix6 stiffness;  ///< C, Pa
  double density;            ///< kg/m3
  Eigen::MatrixXd shapes;    ///< [3 x nodes, modes] u_i of unit modal mass, m
  Eigen::VectorXd values;    ///< [modes] Rayleigh quotients v_i, (rad/s)^2
};

/// The defects of the stresses s_i that make energy + equation/shift least.
/// @param shift  (rad/s)^2
/// @throws std::runtime_error where PETSc or MUMPS can't, for instance without enough memory
[[nodiscard]] StressDefects least_defects(const ElasticModes& modes, const StressSpace& space, double shift);

}  // namespace idiophone::eigenmodes
