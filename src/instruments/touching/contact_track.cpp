#include "idiophone/instruments/touching/contact_track.hpp"

#include <algorithm>
#include <cmath>

namespace idiophone::touching {

namespace {

constexpr double memory = 0.1;        // s
constexpr double settling = 0.05;     // s, of the load
constexpr double least_excess = 2.0;  // times the envelope, of an impact

}  // namespace

ContactTrack::Share ContactTrack::follow(double impulse, double duration) {
  const double usual = envelope_ * std::exp(-duration / memory);
  envelope_ = std::max(usual, impulse);
  silence_ = impulse > 0.0 ? 0.0 : silence_ + duration;
  const double impact = impulse > least_excess * usual ? impulse - usual : 0.0;
  load_ += (1.0 - std::exp(-duration / settling)) * ((impulse - impact) / duration - load_);
  return {.impact = impact, .load = silence_ < memory ? load_ : 0.0};
}

}  // namespace idiophone::touching
