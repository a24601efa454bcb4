#include "idiophone/instruments/drivers/force_budget.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace idiophone::drivers {

namespace {

/// Of the force of an event, s; 0 if it has none.
double duration_of(const score::ScoreEvent& event) {
  if (const auto* blow = std::get_if<score::HammerBlow>(&event.action)) {
    return blow->hammer.contact_duration();
  }
  if (const auto* mallet = std::get_if<score::MalletBlow>(&event.action)) {
    return mallet->blow.hammer.contact_duration();
  }
  if (const auto* force = std::get_if<score::AppliedForce>(&event.action)) {
    return force->end();
  }
  if (const auto* stroke = std::get_if<score::Stroke>(&event.action)) {
    return (stroke->to - stroke->from).norm() / stroke->speed;
  }
  if (const auto* bow = std::get_if<score::Bow>(&event.action)) {
    return bow->duration;
  }
  return 0.0;
}

}  // namespace

void ForceBudget::take(const score::ScoreEvent& event, std::int64_t now) {
  const double duration = duration_of(event);
  std::erase_if(taken_, [&](const Taken& taken) {
    taken_time_ -= taken.end <= now ? taken.duration : 0.0;
    return taken.end <= now;
  });
  if (taken_.empty()) {
    taken_time_ = 0.0;  // no rounding is left
  }
  if (taken_time_ + duration > most) {
    throw std::runtime_error(
        fmt::format("the forces that are not over last {:.3g} s together, and this one {:.3g} s; {} s are possible",
                    taken_time_, duration, most));
  }
  taken_time_ += duration;
  taken_.push_back({now + static_cast<std::int64_t>(std::ceil(duration * rate_)), duration});
}

}  // namespace idiophone::drivers
