#pragma once
// How materials damp modes that are known without losses.

#include <numbers>
#include <span>
#include <vector>

#include "idiophone/scene/material.hpp"
#include "idiophone/solids/solid/relaxation.hpp"

namespace idiophone::eigenmodes {

/// A material in a mode of unit modal mass.
struct MaterialStrain {
  double share = 0.0;              ///< W: x^T K x of the part that it fills, with the elasticity of the deck, 1/s2
  double relaxing = 0.0;           ///< W_r: of W, what the relaxation acts on (StrainedRegion), 1/s2
  double stiffness_damping = 0.0;  ///< beta, s
  solid::Relaxation relaxation;    ///< M, in units of the elasticity of the deck
};

struct DampedVibration {
  double angular_frequency = 0.0;  ///< w without damping, rad/s
  double damping = 0.0;            ///< 2 zeta w, 1/s; zeta is the damping ratio

  [[nodiscard]] double frequency() const { return angular_frequency / (2 * std::numbers::pi); }  ///< Hz
  [[nodiscard]] double decay() const { return damping / 2; }                                     ///< zeta w, 1/s
};

/// The complex modulus M(i w0) of a loss factor turns w0^2 into w0^2 + (M - 1) W_r, to first order in M - 1, and the
/// damping is that of all else + beta W + Im(M) W_r/w.
/// @param square     w0^2 of the lossless body, (rad/s)^2
/// @param of_others  damping that is not in `materials`, 1/s
[[nodiscard]] DampedVibration damped(double square, double of_others, std::span<const MaterialStrain> materials);

/// Modes of a body that nothing damps but the one material which fills it.
/// @param lossless_frequencies  Hz (Mode::lossless_frequency)
/// @return in their order
/// @throws deck::DeckError as solid::relaxation_of(), and for a loss factor by direction: what each mode strains, and
/// how, is not known here
[[nodiscard]] std::vector<DampedVibration> damped_by(const scene::Damping& damping,
                                                     std::span<const double> lossless_frequencies);

}  // namespace idiophone::eigenmodes
