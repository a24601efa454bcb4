#pragma once
// Modes of a body with the air that moves along: the air's mass lowers the frequencies, its resistance damps.

#include <array>
#include <span>
#include <utility>
#include <vector>

#include "idiophone/air/harmonic/boundary_elements.hpp"
#include "idiophone/foundation/part_watch.hpp"
#include "idiophone/foundation/types.hpp"

namespace idiophone::harmonic {

/// Modes without air, and the surface that they move.
struct DryModes {
  std::vector<Vector3> nodes;                   ///< m
  std::vector<std::array<Index, 3>> triangles;  ///< of the closed surface: nodes, normals outwards
  std::vector<std::vector<double>> shapes;      ///< [modes] of [3 x nodes] for unit modal mass, 1/sqrt(kg)
  std::vector<double> frequencies;              ///< [modes] Hz, ascending
  std::vector<double> decays;                   ///< [modes] of the amplitude, without air, 1/s
};

/// A mode with air: a sum of modes without air.
struct WetMode {
  double frequency = 0.0;        ///< Hz
  double decay = 0.0;            ///< of the amplitude, without the radiated sound, 1/s
  double radiation_decay = 0.0;  ///< of the amplitude by the radiated sound, 1/s
  std::vector<double> shares;    ///< [dry modes that are resolved] their factors, for unit modal mass with the air's
};

/// How many of the modes the surface resolves: at least three edges in a wave length of sound.
[[nodiscard]] std::size_t resolved_modes(const DryModes& dry, double speed);

/// By boundary elements, for the body alone in open air. With the impedance Z = R + i w A of the air, integrals of the
/// pressure of one mode over the normal motion of another, modes with air solve w0^2 q = w^2 (1 + A(w)) q. Each has A
/// at its own frequency, found in one step from that of the mode before.
/// @param watch  after each mode; if it ends the work, there are fewer modes, the lowest ones
/// @return  the modes that the surface resolves
[[nodiscard]] std::vector<WetMode> wet_modes(const DryModes& dry, const QuietAir& air, const PartWatch& watch = {});

/// What is made of the numbers of all resolved dry modes for one mode with air: a sum with its shares.
/// @param shapes  [modes] of any length
template <class Values>
[[nodiscard]] std::vector<double> mixed(const WetMode& mode, const std::vector<Values>& shapes) {
  std::vector<double> sum(shapes.front().size());
  for (std::size_t m = 0; m < mode.shares.size(); ++m) {
    for (std::size_t i = 0; i < sum.size(); ++i) {
      sum[i] += mode.shares[m] * shapes[m][i];
    }
  }
  return sum;
}

/// About how far the air lowers the frequency of a mode, cents; too high by up to 90 %. The air moves along to a depth
/// of 1/sqrt(g^2 + k^2 + 4 pi/S), g^2 the mean square of the surface gradient of the normal motion over that of the
/// motion, S the area. A sphere that moves as a spherical harmonic of degree l has g = sqrt(l (l + 1))/a, and the depth
/// is a/(l + 1).
[[nodiscard]] double estimated_shift(const DryModes& dry, std::size_t mode, const QuietAir& air);

/// A smaller shift needs no word, cents.
inline constexpr double audible_shift = 2.0;

/// The mode with the largest estimated_shift() and that shift, cents.
[[nodiscard]] std::pair<std::size_t, double> largest_estimated_shift(const DryModes& dry, const QuietAir& air);

/// Between two frequencies, cents.
[[nodiscard]] double cents(double from, double to);

}  // namespace idiophone::harmonic
