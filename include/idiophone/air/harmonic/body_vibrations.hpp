#pragma once
// How one body, or bodies that joints tie together, move while all else is at rest: modes, rigid motions, or what
// someone measured.

#include <filesystem>
#include <string>
#include <vector>

#include "idiophone/air/harmonic/acoustic_surface.hpp"
#include "idiophone/scene/solids.hpp"

namespace idiophone::harmonic {

/// How a body vibrates: amplitudes, which belong to exp(+i w t).
struct Vibration {
  std::string name;                      ///< "mode 3"
  double frequency = 0.0;                ///< Hz
  double energy = 0.0;                   ///< of an undamped mode at this amplitude, J; 0: has none
  std::vector<ComplexVector> velocity;   ///< [vertices of all parts] m/s
  std::vector<Complex> normal_velocity;  ///< [3 x triangles of all parts] at the corners, m/s
};

/// The lowest modes of one part for a modal velocity of 1 m sqrt(kg)/s, all else at rest. Call on one rank.
/// @param part  of the surface: a body, or bodies that joints tie together
/// @throws deck::DeckError, std::runtime_error as eigenmodes::find_modes()
[[nodiscard]] std::vector<Vibration> modal_vibrations(const scene::Solids& solids, std::size_t part, int count,
                                                      const AcousticSurface& surface);

/// One part moves to and fro along each axis, with 1 m/s, at each frequency.
[[nodiscard]] std::vector<Vibration> rigid_vibrations(std::size_t part, const std::vector<double>& frequencies,
                                                      const AcousticSurface& surface);

/// The velocities of one part, from a file: docs/use/radiate.md#velocities describes it.
/// @return one vibration for each frequency, ascending
/// @throws deck::DeckError or std::runtime_error if the file can't be read, a place is no vertex of the body, or a
/// vertex has not exactly one row at each frequency
[[nodiscard]] std::vector<Vibration> given_vibrations(std::size_t part, const std::filesystem::path& file,
                                                      const AcousticSurface& surface);

}  // namespace idiophone::harmonic
