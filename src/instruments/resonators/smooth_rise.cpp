#include "idiophone/instruments/resonators/smooth_rise.hpp"

#include <algorithm>
#include <cmath>

namespace idiophone::resonators {

SmoothRise::SmoothRise(double angular_frequency, double step)
    : angular_frequency_(angular_frequency), step_(DampedOscillator(0.0, angular_frequency).step(step)) {}

void SmoothRise::advance(double begin, double end) {
  smooth_ = step_.turn.real() * smooth_ + angular_frequency_ * (step_.first.real() * begin + step_.last.real() * end);
}

std::size_t samples_of_rise(double angular_frequency, int rate) {
  constexpr double negligible = 1e-5;  // of the force
  constexpr double longest = 1.0;      // s
  return static_cast<std::size_t>(std::ceil(std::min(-std::log(negligible) / angular_frequency, longest) * rate));
}

void add_rise(ForceCurve& force, double angular_frequency, int rate) {
  force.resize(force.size() + samples_of_rise(angular_frequency, rate));
  SmoothRise rise(angular_frequency, 1.0 / rate);
  for (ForcePiece& piece : force) {
    piece.rise = rise.at(piece.begin) / rate;
    rise.advance(piece.mean - piece.slope, piece.mean + piece.slope);
  }
}

}  // namespace idiophone::resonators
