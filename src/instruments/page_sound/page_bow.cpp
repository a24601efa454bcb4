#include "page_bow.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace idiophone::page_sound {

namespace {

constexpr double follow_time = 0.02;  // s

/// A bow whose speed and load are zero until somebody leads it.
score::Bow resting(const friction::Law& friction) {
  score::Bow bow;
  bow.speed = bow.load = {.points = {{}}};
  bow.friction = friction;
  return bow;
}

}  // namespace

PageBow::PageBow(const friction::Law& friction, Participation place, int rate)
    : bow_(resting(friction), rate), follow_(std::llround(follow_time * rate)), from_(place), to_(std::move(place)) {}

void PageBow::lead(const resonators::ContactMotion& motion, Participation place) {
  from_ = next_place(0);
  to_ = std::move(place);
  moved_ = 0;
  bow_.lead(motion, follow_);
}

void PageBow::lift() {
  lead({.speed = bow_.motion().speed, .load = 0.0}, to_);
  is_lifted_ = true;
}

Participation PageBow::next_place(std::int64_t samples) {
  const double share = std::min(1.0, static_cast<double>(moved_) / static_cast<double>(follow_));
  Participation place;
  for (std::size_t mode = 0; mode < to_.size(); ++mode) {
    place.push_back(std::lerp(from_[mode], to_[mode], share));
  }
  moved_ += samples;
  return place;
}

}  // namespace idiophone::page_sound
