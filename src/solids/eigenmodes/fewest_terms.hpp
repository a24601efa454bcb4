#pragma once
// Stretching in as few terms as possible.

#include <vector>

#include "idiophone/solids/modal_bodies/stretching.hpp"

namespace idiophone::eigenmodes {

/// The same stretching along other strains: those along which random vibrations have the most energy of stretching are
/// kept. In the space of these, others take their place that have as few pairs of modes as possible. Then
/// pairs of modes that have little energy in a term become zero there: of a symmetric body, most do. The vibrations are
/// normally distributed, with the same energy in all modes on average.
/// @param frequencies  [modes] rad/s
/// @param tolerance    share of the mean energy of stretching that may be left out
[[nodiscard]] modal_bodies::Stretching in_fewest_terms(const modal_bodies::Stretching& stretching,
                                                       const std::vector<double>& frequencies, double tolerance);

}  // namespace idiophone::eigenmodes
