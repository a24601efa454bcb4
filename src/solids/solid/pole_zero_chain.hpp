#pragma once
// The modulus of a loss factor as M(s) = K prod_i (s + z_i)/(s + p_i), with zeros and poles z_i, p_i = w_i exp(-+ y_i).
// At s = i w a pair adds the phase atan(sinh(y_i)/cosh(ln(w/w_i))), nearly y_i/cosh(ln(w/w_i)): the y_i that make the
// phase what is wanted are the solution of linear equations. Positive y_i of pairs that do not overlap give partial
// fractions with positive weights, which is the generalised Maxwell solid.

#include <limits>
#include <vector>

#include "idiophone/scene/loss_factor.hpp"

namespace idiophone::solid {

/// Pole-zero pairs, and how far the loss factor strays in the band.
struct PoleZeroChain {
  std::vector<double> centres;                                 ///< ln(w_i)
  std::vector<double> strengths;                               ///< y_i
  double deviation = std::numeric_limits<double>::infinity();  ///< largest |tan(phi)/loss factor - 1| in the band
};

/// The chain with fewest pairs that keeps the loss factor within 5 %, or with as many as the deck asks for. A measured
/// curve may have corners that no chain can follow: then one that is nearly as close as any, and within 25 %.
/// @throws deck::DeckError as fit_relaxation()
[[nodiscard]] PoleZeroChain fitted_chain(const scene::LossFactor& loss);

}  // namespace idiophone::solid
