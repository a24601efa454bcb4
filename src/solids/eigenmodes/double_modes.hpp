#pragma once
// Two modes of one frequency can be mixed at will. Of a round body, one choice has far fewer products of modes that are
// not zero than others: cosines and sines about one meridian.

#include <span>
#include <vector>

#include "eigensolver.hpp"
#include "idiophone/foundation/types.hpp"

namespace idiophone::eigenmodes {

/// Mixes the two modes of each double frequency so that they move one place in perpendicular directions: the place that
/// is farthest from the middle of all nodes, and of several the one with the largest x. On a round body, each mode is
/// then even or odd about the plane through its axis and this place. Their product by the mass stays.
/// @param pairs  ascending, on one rank. Frequencies that differ by less than 1e-5 of themselves are the same
/// @param nodes  [nodes] m
void align_double_modes(std::span<Eigenpair> pairs, std::span<const Vector3> nodes);

}  // namespace idiophone::eigenmodes
