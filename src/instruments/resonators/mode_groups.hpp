#pragma once
// Arithmetic on groups of modes.

#include <cstddef>

#include "idiophone/instruments/resonators/resonator_bank.hpp"

namespace idiophone::resonators {

/// Makes z the product of complex numbers, mode by mode. It can be a or b. GCC would move a result through the memory.
/// @tparam Group  ModeGroup or SingleGroup
template <class Group>
inline void multiply(Group& z, const Group& a, const Group& b) {
  for (std::size_t p = 0; p < z.real.size(); ++p) {
    const auto real = a.real[p] * b.real[p] - a.imaginary[p] * b.imaginary[p];
    z.imaginary[p] = a.real[p] * b.imaginary[p] + a.imaginary[p] * b.real[p];
    z.real[p] = real;
  }
}

/// The sums with Re(gain z) of every mode. Two sums in a row are two operations, their difference in one expression
/// would be three.
template <class Group, class Pack>
inline Pack with_sound(Pack sum, const Group& gain, const Group& z) {
  for (std::size_t p = 0; p < z.real.size(); ++p) {
    sum += gain.real[p] * z.real[p];
    sum -= gain.imaginary[p] * z.imaginary[p];
  }
  return sum;
}

/// The gains of one group.
template <std::size_t outputs>
using GroupGains = std::array<const ModeGroup*, outputs>;

/// @param gains  [outputs x groups]
template <std::size_t outputs>
inline GroupGains<outputs> gains_of(std::size_t group, std::size_t groups, std::span<const ModeGroup> gains) {
  GroupGains<outputs> of_group;
  for (std::size_t o = 0; o < outputs; ++o) {
    of_group[o] = &gains[o * groups + group];
  }
  return of_group;
}

/// A call would put the state into memory, which costs a quarter of the time of `play`.
[[gnu::always_inline]] inline void drive(ModeGroup& state, const Drive& drive, std::size_t group, std::size_t sample) {
  const ForcePiece piece = drive.force[sample];
  const ModeGroup& mean = drive.by_mean[group];
  const ModeGroup& slope = drive.by_slope[group];
  for (std::size_t p = 0; p < packs_in_group; ++p) {
    state.real[p] += piece.mean * mean.real[p] + piece.slope * slope.real[p];
    state.imaginary[p] += piece.mean * mean.imaginary[p] + piece.slope * slope.imaginary[p];
  }
}

}  // namespace idiophone::resonators
