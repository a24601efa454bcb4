#pragma once
// The stiffness of solids that depends on the direction: of wood, and of crystals of any symmetry.

#include <Eigen/Core>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "idiophone/foundation/types.hpp"

namespace idiophone::scene {

/// Elastic constants of an orthotropic material along its three axes, e.g. of wood. Poisson's ratio nu_ij is the
/// contraction along j under tension along i; nu_ij/E_i = nu_ji/E_j.
struct Orthotropy {
  Vector3 young = Vector3::Zero();    ///< E_x, E_y, E_z, Pa
  Vector3 poisson = Vector3::Zero();  ///< nu_xy, nu_yz, nu_xz
  Vector3 shear = Vector3::Zero();    ///< G_xy, G_yz, G_xz, Pa
};

/// What the stiffness of a crystal is symmetric about. The main axis is z; of `monoclinic`, the twofold axis is y.
enum class Symmetry { cubic, hexagonal, trigonal, tetragonal, orthotropic, monoclinic, triclinic };

/// One independent constant of a symmetry: c_ij of the stiffness matrix, Pa.
struct CrystalConstant {
  std::string name;          ///< "c14"
  bool is_diagonal = false;  ///< i = j: above 0
  bool is_optional = false;  ///< 0 if omitted: c15 of trigonal and c16 of tetragonal crystals, which some classes lack
  std::string_view places;   ///< in the matrix, with their factors: "14 -24 56", or "66/2" for a half
};

/// Elastic constants of a crystal along its axes.
struct Crystal {
  Symmetry symmetry = Symmetry::triclinic;
  std::vector<double> constants;  ///< of independent_constants(symmetry), Pa
};

/// S = C E as six numbers each, S = (S_xx, S_yy, S_zz, S_yz, S_xz, S_xy), E = (E_xx, E_yy, E_zz, 2 E_yz, 2 E_xz, 2
/// E_xy); C in Pa, symmetric.
using StiffnessMatrix = Eigen::Matrix<double, 6, 6>;

/// The independent constants of a symmetry (Nye, Physical Properties of Crystals, 1957, table 9).
[[nodiscard]] std::span<const CrystalConstant> independent_constants(Symmetry symmetry);

/// C along the material's own axes.
[[nodiscard]] StiffnessMatrix stiffness_matrix(const Crystal& crystal);
[[nodiscard]] StiffnessMatrix stiffness_matrix(const Orthotropy& constants);

/// The six moduli by which a solid resists its own strains, ascending, Pa: the eigenvalues of C as a tensor (Lord
/// Kelvin 1856). Of an isotropic solid, five are 2 mu and one is three times the bulk modulus.
[[nodiscard]] Eigen::Vector<double, 6> kelvin_moduli(const StiffnessMatrix& stiffness);

}  // namespace idiophone::scene
