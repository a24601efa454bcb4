#pragma once
// A room: a box of walls that reflect and absorb sound.

#include <array>
#include <cstddef>
#include <optional>

#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/foundation/types.hpp"

namespace idiophone::scene {

/// A number for each octave band, with centres at 125, 250, 500, 1000, 2000 and 4000 Hz. The lowest is also that of all
/// lower frequencies, the highest that of all higher ones.
using OctaveBands = std::array<double, 6>;

inline constexpr double lowest_octave = 125.0;  ///< its centre, Hz

/// Walls are numbered left (lowest x), right, front (lowest y), back, floor (lowest z), ceiling.
struct Room {
  static constexpr std::size_t walls = 6;

  Vector3 size = Vector3::Zero();               ///< edges along x, y and z, m
  Vector3 corner = Vector3::Zero();             ///< the one with the lowest x, y and z, m
  std::array<OctaveBands, walls> absorption{};  ///< absorbed energy over incident energy, 0 to 1
  std::optional<int> images;                    ///< wanted order of the image sources
  bool late = true;                             ///< whether a late field follows the image sources
  deck::Location where;

  /// Reflections of the paths that are computed one by one: `images`, or so many that 60 dB are lost, but no more than
  /// 3 where a late field follows and 10 elsewhere.
  [[nodiscard]] int order() const;

  /// How far a point is outside, m; 0 inside.
  [[nodiscard]] double distance_outside(const Vector3& point) const;

  [[nodiscard]] Vector3 centre() const { return corner + 0.5 * size; }
  [[nodiscard]] double volume() const { return size.prod(); }  ///< m3
  [[nodiscard]] double surface() const;                        ///< of all walls, m2
  [[nodiscard]] double wall_area(std::size_t wall) const;      ///< m2

  /// Whether all walls absorb all frequencies alike.
  [[nodiscard]] bool absorbs_evenly() const;

  /// Loss of energy in a reflection, -ln(1 - absorption), Np (as energy); at most 27.6 (120 dB).
  [[nodiscard]] double loss(std::size_t wall, std::size_t band) const;

  /// By which the energy of a diffuse field decays: c S a/(4 V), a = -ln(1 - mean absorption over the area), 1/s
  /// (Eyring, Reverberation time in "dead" rooms, JASA 1, 1930).
  /// @param speed  of sound, m/s
  [[nodiscard]] double decay_rate(std::size_t band, double speed) const;
};

}  // namespace idiophone::scene
