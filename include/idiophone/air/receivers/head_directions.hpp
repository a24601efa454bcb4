#pragma once
// The measured direction of a head that is used for each triangle, and the crossfade from one to the next.

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "idiophone/foundation/parallel/archive_row.hpp"

namespace idiophone::receivers {

/// A filter, and the weight of a sound at its input.
struct FilterWeight {
  std::int64_t number = 0;
  double weight = 0.0;
};
/// Two filters whose weights add up to one.
using Crossfade = std::array<FilterWeight, 2>;

/// One number per triangle, updated at audio samples that are multiples of `interval`. Between two updates the sound
/// crosses over from the previous number to the current one, linearly with the time of emission.
class HeadDirections {
 public:
  HeadDirections(std::size_t triangles, int interval)
      : interval_(interval), current_(triangles, none), previous_(triangles, none) {}

  /// Calls `nearest` for the triangles' numbers if an update is due at this audio sample.
  void update(std::int64_t sample, const std::function<std::int64_t(std::size_t triangle)>& nearest);

  /// For a triangle's sound emitted at an audio sample.
  [[nodiscard]] Crossfade crossfade(std::int64_t sample, std::size_t triangle) const;

  /// A triangle's state.
  void archive(std::size_t triangle, parallel::ArchiveRow& row);

 private:
  /// Audio samples since the last multiple of `interval`.
  [[nodiscard]] std::int64_t age(std::int64_t sample) const { return ((sample % interval_) + interval_) % interval_; }

  static constexpr std::int64_t none = -1;  // before the first update
  int interval_;
  std::vector<std::int64_t> current_, previous_;  // [triangles]
};

}  // namespace idiophone::receivers
