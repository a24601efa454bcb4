#pragma once
// Materials of a deck: elastic constants, density and damping.

#include <array>
#include <optional>
#include <string>

#include "idiophone/deck/location.hpp"
#include "idiophone/types.hpp"

namespace idiophone::scene {

/// Internal friction that is the same at all frequencies of a band: a mode of frequency f there loses the energy
/// 2 pi `value` of what it has in each period, its amplitude falls as exp(-pi f value t).
struct LossFactor {
  double value = 0.0;                            ///< tan(phi), above 0
  std::array<double, 2> band = {20.0, 20000.0};  ///< Hz, ascending
  std::optional<int> mechanisms;                 ///< of relaxation; as few as will do where not given
  deck::Location where;
};

/// Mass- and stiffness-proportional damping: a mode of angular frequency w has the damping ratio
/// zeta = mass/(2 w) + stiffness w/2. A loss factor adds half of itself.
struct Damping {
  double mass = 0.0;       ///< alpha, 1/s
  double stiffness = 0.0;  ///< beta, s (Kelvin-Voigt: phi = beta lambda, psi = beta mu)
  std::optional<LossFactor> loss = {};
};

/// Elastic constants along three axes at right angles, of wood for instance. poisson ij is how much the material
/// shrinks along j where it is pulled along i, so that nu_ij/E_i = nu_ji/E_j.
struct Orthotropy {
  Vector3 young = Vector3::Zero();    ///< E_x, E_y, E_z, Pa
  Vector3 poisson = Vector3::Zero();  ///< nu_xy, nu_yz, nu_xz
  Vector3 shear = Vector3::Zero();    ///< G_xy, G_yz, G_xz, Pa
};

/// Elastic material.
struct Material {
  std::string name;
  double young = 0.0;    ///< Young's modulus, Pa; the largest of an orthotropic material
  double poisson = 0.0;  ///< Poisson's ratio, in (-1, 0.5); of an isotropic material
  double density = 0.0;  ///< kg/m3
  Damping damping;
  deck::Location where;
  std::optional<Orthotropy> orthotropy = {};  ///< where it is not the same in all directions
};

}  // namespace idiophone::scene
