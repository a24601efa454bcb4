#pragma once
// Random numbers that do not depend on the standard library, but for the rounding of log. Those of <random>'s
// distributions do.

#include <cmath>
#include <optional>
#include <random>
#include <utility>

namespace idiophone {

/// Uniform from 0 up to 1.
inline double uniform(std::mt19937_64& random) {
  return static_cast<double>(random() >> 11U) * 0x1p-53;
}

/// Numbers with a normal distribution of mean 0 and deviation 1, always the same ones, by the polar method (Marsaglia
/// and Bray 1964).
class NormalNumbers {
 public:
  double next() {
    if (spare_) {
      return *std::exchange(spare_, std::nullopt);
    }
    while (true) {
      const double x = 2 * uniform(random_) - 1;
      const double y = 2 * uniform(random_) - 1;
      if (const double square = x * x + y * y; square > 0 && square <= 1) {
        const double scale = std::sqrt(-2 * std::log(square) / square);
        spare_ = scale * x;
        return scale * y;
      }
    }
  }

 private:
  std::mt19937_64 random_;
  std::optional<double> spare_;  // each point of the plane gives two
};

}  // namespace idiophone
