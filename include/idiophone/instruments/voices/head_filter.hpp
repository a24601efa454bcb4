#pragma once
// One body's sound at the ears of a head: the responses from one direction, and a crossfade to those from another.

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace idiophone::voices {

/// Allocates in its constructor only.
class HeadFilter {
 public:
  /// @param responses  [2 x taps]: left, right
  explicit HeadFilter(std::span<const double> responses);

  /// Sets the responses that come next.
  void begin(std::span<const double> responses);

  /// Those that come next become the present ones.
  void end();

  /// Left and right ear in the next audio sample.
  /// @param pressure  at the head's centre without the head, Pa
  /// @param share     of the responses that come next, 0 to 1
  [[nodiscard]] std::array<double, 2> hear(double pressure, double share);

 private:
  [[nodiscard]] double convolved(std::span<const double> response) const;

  std::size_t taps_;
  std::vector<double> responses_, next_;  // [2 x taps]
  std::vector<double> heard_;             // [2 x taps] the last samples, latest first, from newest_ on
  std::size_t newest_ = 0;
  std::size_t silent_;  // samples since the last sound, up to taps
};

}  // namespace idiophone::voices
