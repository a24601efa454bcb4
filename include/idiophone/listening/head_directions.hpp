#pragma once
// From which measured direction of a head each triangle is heard, and the change from one to the next without a click.

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "idiophone/parallel/archive_row.hpp"

namespace idiophone::listening {

/// Parts of a sound that go to different filters; they add up to one.
struct Share {
  std::int64_t number = 0;
  double part = 0.0;
};
using Shares = std::array<Share, 2>;

/// One number a triangle, looked up anew at audio samples that are multiples of `renewal`. Until the next of them, the
/// sound goes over from the number before to the present one, linearly with the time of emission.
class HeadDirections {
 public:
  HeadDirections(std::size_t triangles, int renewal)
      : renewal_(renewal), present_(triangles, none), before_(triangles, none) {}

  /// Has `nearest` look the triangles' numbers up if that is due at this audio sample.
  void keep_up(std::int64_t sample, const std::function<std::int64_t(std::size_t triangle)>& nearest);

  /// Of a triangle's sound emitted at the audio sample.
  [[nodiscard]] Shares shares(std::int64_t sample, std::size_t triangle) const;

  /// A triangle's state.
  void archive(std::size_t triangle, parallel::ArchiveRow& row);

 private:
  /// Audio samples since the last that is a multiple of `renewal`.
  [[nodiscard]] std::int64_t age(std::int64_t sample) const { return ((sample % renewal_) + renewal_) % renewal_; }

  static constexpr std::int64_t none = -1;  // before anything was heard
  int renewal_;
  std::vector<std::int64_t> present_, before_;  // [triangles]
};

}  // namespace idiophone::listening
