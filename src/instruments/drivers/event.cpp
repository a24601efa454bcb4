#include "idiophone/instruments/drivers/event.hpp"

#include <algorithm>
#include <cmath>

#include "idiophone/instruments/resonators/force.hpp"

namespace idiophone::drivers {

namespace {

Strength strength_of(const score::HammerBlow& blow) {
  return {.force = resonators::HertzPulse(blow.hammer).peak,
          .impulse = 2.0 * blow.hammer.mass * blow.hammer.speed,
          .speed = blow.hammer.speed};
}

Strength strength_of(const score::Stroke& stroke) {
  return {.force = stroke.load,
          .impulse = stroke.load * (stroke.to - stroke.from).norm() / stroke.speed,
          .speed = stroke.speed};
}

Strength strength_of(const resonators::PointForce& force, int rate) {
  Strength strength;
  for (const resonators::ForcePiece& piece : force.force) {
    const double newtons = std::abs(piece.mean) * force.direction.norm();
    strength.force = std::max(strength.force, newtons);
    strength.impulse += newtons / rate;
  }
  return strength;
}

}  // namespace

Event event_of(const score::ScoreEvent& event, std::int64_t start, std::uint64_t seed, int rate) {
  Event found{.start = start, .body = event.body, .action = {}};
  if (const auto* tuning = std::get_if<score::Tuning>(&event.action)) {
    found.action = *tuning;
    return found;
  }
  if (const auto* detail = std::get_if<score::Detail>(&event.action)) {
    found.action = *detail;
    return found;
  }
  if (const auto* bow = std::get_if<score::Bow>(&event.action)) {
    found.action = Touching{.contact = *bow};
    return found;
  }
  if (const auto* mallet = std::get_if<score::MalletBlow>(&event.action)) {
    found.action = Touching{.contact = *mallet};
    return found;
  }
  Excitation excitation{.forces = resonators::point_forces(event, start, seed, rate), .strength = {}};
  if (const auto* blow = std::get_if<score::HammerBlow>(&event.action)) {
    excitation.strength = strength_of(*blow);
  } else if (const auto* stroke = std::get_if<score::Stroke>(&event.action)) {
    excitation.strength = strength_of(*stroke);
  } else {
    excitation.strength = strength_of(excitation.forces.front(), rate);
  }
  found.action = std::move(excitation);
  return found;
}

}  // namespace idiophone::drivers
