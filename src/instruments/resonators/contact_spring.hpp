#pragma once
// The contact of a tool on a rough surface: what strokes that are known before and those that a player leads have in
// common.

#include <cmath>

#include "idiophone/instruments/resonators/damped_oscillator.hpp"
#include "idiophone/instruments/score/action.hpp"

namespace idiophone::resonators {

/// A tool as a mass on the spring of Hertz' contact, linear about the load.
class ContactSpring {
 public:
  /// @param load  that presses the tool on, N; above 0
  ContactSpring(const score::Stroke& stroke, double load) : size_(stroke.size) {
    const double approach = std::pow(load / stroke.hardness, 2.0 / 3.0);
    spring_ = 1.5 * stroke.hardness * std::sqrt(approach);
    angular_ = std::sqrt(spring_ / stroke.mass);
  }

  /// Force of a wave of the height 1 m that passes, N/m: the tool follows it below its own frequency and is left behind
  /// above, and the contact does not feel waves that are short compared with its size.
  /// @param angular_frequency  rad/s
  /// @param wave_number        rad/m
  [[nodiscard]] Complex force(double angular_frequency, double wave_number) const {
    constexpr double damping = 0.1;  // ratio to critical, of the tool on its contact
    const Complex s(0.0, angular_frequency / angular_);
    const double felt = wave_number * size_;
    return std::exp(-felt * felt / 8.0) * spring_ * s * s / (s * s + 2.0 * damping * s + 1.0);
  }

 private:
  double spring_;   // N/m
  double angular_;  // rad/s
  double size_;     // m
};

}  // namespace idiophone::resonators
