#pragma once
// Materials of a deck: elastic constants, density and damping.

#include <optional>
#include <string>

#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/scene/anisotropy.hpp"
#include "idiophone/scene/loss_factor.hpp"

namespace idiophone::scene {

/// What mass-proportional damping slows: every motion, or the vibration and not the rigid motion.
enum class DampedMotion { all, vibration };

/// Mass- and stiffness-proportional damping: a mode of angular frequency w has the damping ratio
/// zeta = mass/(2 w) + stiffness w/2. A loss factor adds half of itself.
struct Damping {
  double mass = 0.0;       ///< alpha, 1/s
  double stiffness = 0.0;  ///< beta, s (Kelvin-Voigt: phi = beta lambda, psi = beta mu)
  std::optional<LossFactor> loss = {};
  DampedMotion mass_of = DampedMotion::all;

  [[nodiscard]] bool has_directional_loss() const { return loss && loss->directions; }
  /// alpha of a damping force on every motion, 1/s.
  [[nodiscard]] double of_all_motion() const { return mass_of == DampedMotion::all ? mass : 0.0; }
  /// alpha that acts on the vibration alone, 1/s.
  [[nodiscard]] double of_vibration() const { return mass_of == DampedMotion::vibration ? mass : 0.0; }
};

/// Elastic material.
struct Material {
  std::string name;
  double young = 0.0;    ///< Young's modulus, Pa; the largest along the axes of a material that is not isotropic
  double poisson = 0.0;  ///< Poisson's ratio, in (-1, 0.5); of an isotropic material
  double density = 0.0;  ///< kg/m3
  Damping damping;
  deck::Location where;
  std::optional<Orthotropy> orthotropy = {};
  std::optional<Crystal> crystal = {};   ///< at most one of the two; none: isotropic
  std::optional<double> expansion = {};  ///< by which a length grows with the temperature, of itself, 1/K

  [[nodiscard]] bool is_isotropic() const { return !orthotropy && !crystal; }
};

/// Young's moduli, Poisson's ratios and shear moduli along the axes of a material: its orthotropy, or those that a
/// crystal has along its axes. A crystal's coupling of pulls and shears is left out. None: the material is isotropic.
[[nodiscard]] std::optional<Orthotropy> constants_along_axes(const Material& material);

}  // namespace idiophone::scene
