#include "idiophone/air/surface/sampling.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <string_view>

namespace idiophone::surface {

namespace {

void require(bool right, std::string_view name, double value, std::string_view range) {
  if (!right) {
    throw std::invalid_argument(fmt::format("surface sampling: {} is {}; it has to be {}", name, value, range));
  }
}

}  // namespace

int Sampling::half_width() const {
  const double step = 1.0 / (static_cast<double>(rate) * steps_per_sample);
  // A whole number of steps must not become one more by rounding.
  return static_cast<int>(std::ceil(kernel_wavelengths / (max_frequency * step) - 1e-6));
}

int Sampling::latency() const {
  return (half_width() + steps_per_sample - 1) / steps_per_sample;
}

void Sampling::validate() const {
  require(rate >= 1 && rate <= 1'000'000, "rate", rate, "1 to 1000000 samples per second");
  require(steps_per_sample >= 1 && steps_per_sample <= 100'000, "steps_per_sample", steps_per_sample, "1 to 100000");
  require(steps_per_read >= 1 && steps_per_sample % steps_per_read == 0, "steps_per_read", steps_per_read,
          fmt::format("a divisor of steps_per_sample, {}", steps_per_sample));
  require(max_frequency >= 0.01 * rate && max_frequency <= 0.5 * rate, "max_frequency", max_frequency,
          fmt::format("{} to {} Hz, half the audio rate", 0.01 * rate, 0.5 * rate));
  require(kernel_wavelengths >= 0.5 && kernel_wavelengths <= 32.0, "kernel_wavelengths", kernel_wavelengths,
          "0.5 to 32");
  require(impedance > 0.0 && std::isfinite(impedance), "impedance", impedance, "positive, in Pa s/m");
}

int choose_steps_per_read(int steps_per_sample, int rate, double max_frequency) {
  int chosen = 1;
  for (int divisor = 2; divisor <= steps_per_sample; ++divisor) {
    const double read_rate = static_cast<double>(steps_per_sample) * rate / divisor;
    if (steps_per_sample % divisor == 0 && read_rate >= 12.0 * max_frequency) {
      chosen = divisor;
    }
  }
  return chosen;
}

}  // namespace idiophone::surface
