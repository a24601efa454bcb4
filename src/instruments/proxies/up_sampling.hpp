#pragma once
// From a sound at a low rate to the audio rate (O'Morain 2005, chapter 5).

#include <array>
#include <cstdint>
#include <vector>

namespace idiophone::proxies {

/// The Hermite curve between the second and the third of four samples (eq. 5.1), with the slopes from the first to the
/// second and from the third to the fourth as tangents (figure 5.2).
/// @param share  of the way from the second to the third, 0 to 1
[[nodiscard]] double hermite(const std::array<double, 4>& samples, double share);

/// Up-samples one sound whose rate is the audio rate over a power of two. All divisors have the same delay.
class UpSampler {
 public:
  /// Audio samples by which sounds are late if divisors up to a largest one are possible. The curve needs the sample
  /// after its end, which takes two intervals. Without lower rates there is no delay.
  [[nodiscard]] static std::int64_t delay(int largest_divisor) { return largest_divisor > 1 ? 2 * largest_divisor : 0; }

  /// @param largest_divisor  1 or a power of two
  explicit UpSampler(int largest_divisor);

  /// Begins with silence. No allocation.
  void restart(int divisor);

  /// The present divisor.
  [[nodiscard]] int divisor() const { return divisor_; }

  /// A new sample, due at audio samples that are multiples of the divisor.
  void add(double value);

  /// The next audio sample. @param place  audio samples since the last one that was due: 0 to divisor - 1
  double take(int place);

 private:
  int largest_divisor_;
  int divisor_ = 1;
  std::array<double, 4> samples_{};
  std::vector<double> ring_;  // what waits until all divisors have the same delay
  std::size_t next_ = 0;
};

}  // namespace idiophone::proxies
