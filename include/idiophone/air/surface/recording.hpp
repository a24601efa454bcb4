#pragma once
// The motion of all surfaces at the audio rate as a recording keeps it (docs/use/surface_motion.md).

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "idiophone/foundation/origin.hpp"
#include "idiophone/foundation/parallel/rows.hpp"

namespace idiophone::surface {

/// How long the old triangles fade out and the new ones fade in where a recording's triangles change, s.
inline constexpr double fade_of_changes = 0.01;

/// The first triangle and vertex of one body; the last ones are before those of the next body.
struct BodyOffsets {
  std::string name;
  std::int32_t first_triangle = 0;
  std::int32_t first_vertex = 0;
};

/// All of a recorded motion but the motion itself. The same on all ranks.
struct RecordingHeader {
  Origin origin;
  double rate = 0.0;                       ///< rows per second: audio samples
  std::int64_t first_sample = 0;           ///< audio sample of row 0, at most 0: the motion before was steady
  std::int64_t samples = 0;                ///< of sound after the recorded motion
  double air_density = 0.0;                ///< used for the pressures, kg/m3
  double air_speed = 0.0;                  ///< speed of sound, likewise, m/s
  std::vector<BodyOffsets> bodies;         ///< in ascending order
  std::vector<double> obstacle_triangles;  ///< [9 x triangles] corners of obstacles, m
  std::vector<double> half_spaces;         ///< [6 x half-spaces] a point of the plane, m, and its outward normal
};

/// The partitioned surface. Triangles and vertices are numbered over all bodies.
struct RecordedSurface {
  const parallel::Rows* triangles = nullptr;  ///< those of this rank
  const parallel::Rows* vertices = nullptr;   ///< likewise
  std::span<const std::int32_t> corners;      ///< [3 x local triangles] global vertex numbers
  std::span<const double> reference;          ///< [3 x local vertices] undeformed positions, m
};

}  // namespace idiophone::surface
