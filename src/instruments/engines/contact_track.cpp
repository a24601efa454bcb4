#include "contact_track.hpp"

#include <algorithm>
#include <cmath>

namespace idiophone::engines {

namespace {

constexpr double memory = 0.1;        // s
constexpr double least_excess = 2.0;  // times the envelope, of an impact

}  // namespace

ContactTrack::Share ContactTrack::follow(double impulse, double duration) {
  const double usual = envelope_ * std::exp(-duration / memory);
  envelope_ = std::max(usual, impulse);
  silence_ = impulse > 0.0 ? 0.0 : silence_ + duration;
  return {.impact = impulse > least_excess * usual ? impulse - usual : 0.0,
          .load = std::min(impulse, usual) / duration};
}

}  // namespace idiophone::engines
