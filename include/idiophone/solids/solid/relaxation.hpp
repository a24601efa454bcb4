#pragma once
// A loss factor that is known throughout a band of frequencies, as a generalised Maxwell solid: a spring with springs
// beside it that creep away through dashpots.

#include <complex>
#include <vector>

#include "idiophone/scene/material.hpp"

namespace idiophone::solid {

/// The complex modulus M(s) = long_term + sum of strength s/(s + rate), in units of the elastic constants in the deck.
struct Relaxation {
  struct Mechanism {
    double strength;  ///< g_i > 0, without unit
    double rate;      ///< 1/tau_i, 1/s
  };
  double long_term = 1.0;  ///< modulus at frequency 0
  std::vector<Mechanism> mechanisms;
  double deviation = 0.0;  ///< largest |tan(phi)/loss factor - 1| in the band that it was fitted to

  /// Modulus at frequencies far above the band, and against a blow.
  [[nodiscard]] double instantaneous() const;

  /// Damping there as 2 zeta w: the sum of strength times rate, over the modulus, 1/s.
  [[nodiscard]] double instantaneous_damping() const;

  /// M(i w): the real part is the storage modulus, the imaginary over the real part the loss factor tan(phi).
  /// @param frequency  w, rad/s
  [[nodiscard]] std::complex<double> modulus(double frequency) const;
};

/// Fits mechanisms so that tan(phi) is the loss factor within 5 % throughout its band, and the storage modulus 1 in the
/// band's (geometric) middle. Of a loss factor by direction, this is the largest one. A curve over the frequency that
/// can't be kept within 5 % is kept as well as possible, within 25 %.
/// @throws deck::DeckError where the number of mechanisms that the deck asks for can't do that, or no number can
[[nodiscard]] Relaxation fit_relaxation(const scene::LossFactor& loss);

/// A dashpot in series with the whole solid: M(s) s/(s + rate). A mode of angular frequency w then satisfies
/// s^2 + rate s + w^2 = 0, as by mass-proportional damping, but its force is a stress: rigid motion keeps its momentum
/// and angular momentum. A stress that lasts makes the solid creep.
/// @param rate  alpha, 1/s
[[nodiscard]] Relaxation creeping(const Relaxation& relaxation, double rate);

}  // namespace idiophone::solid
