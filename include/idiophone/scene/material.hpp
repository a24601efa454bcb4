#pragma once
// Materials of a deck: elastic constants, density and damping.

#include <array>
#include <optional>
#include <string>

#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/foundation/types.hpp"

namespace idiophone::scene {

/// Internal friction, constant over a band of frequencies: a mode of frequency f in the band loses the fraction
/// 2 pi `value` of its energy per period; its amplitude decays as exp(-pi f value t).
struct LossFactor {
  double value = 0.0;                            ///< tan(phi), above 0
  std::array<double, 2> band = {20.0, 20000.0};  ///< Hz, ascending
  std::optional<int> mechanisms;                 ///< number of relaxation mechanisms; as few as possible if omitted
  deck::Location where;
};

/// What mass-proportional damping slows: every motion, or the vibration and not the rigid motion.
enum class DampedMotion { all, vibration };

/// Mass- and stiffness-proportional damping: a mode of angular frequency w has the damping ratio
/// zeta = mass/(2 w) + stiffness w/2. A loss factor adds half of itself.
struct Damping {
  double mass = 0.0;       ///< alpha, 1/s
  double stiffness = 0.0;  ///< beta, s (Kelvin-Voigt: phi = beta lambda, psi = beta mu)
  std::optional<LossFactor> loss = {};
  DampedMotion mass_of = DampedMotion::all;

  /// alpha of a damping force on every motion, 1/s.
  [[nodiscard]] double of_all_motion() const { return mass_of == DampedMotion::all ? mass : 0.0; }
  /// alpha that acts on the vibration alone, 1/s.
  [[nodiscard]] double of_vibration() const { return mass_of == DampedMotion::vibration ? mass : 0.0; }
};

/// Elastic constants of an orthotropic material along its three axes, e.g. of wood. Poisson's ratio nu_ij is the
/// contraction along j under tension along i; nu_ij/E_i = nu_ji/E_j.
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
  std::optional<Orthotropy> orthotropy = {};  ///< none: isotropic
};

}  // namespace idiophone::scene
