#include "idiophone/instruments/touching/contact_sounds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "idiophone/instruments/resonators/force.hpp"
#include "idiophone/instruments/touching/vectors.hpp"
#include "surface_pair.hpp"

namespace idiophone::touching {

namespace {

constexpr double slowest_impact = 1e-4;  // m/s
constexpr double slowest_stroke = 1e-3;  // m/s
constexpr double forgotten_after = 0.5;  // s

double speed_of(const ContactEvent& event) {
  return std::max(vector_of(event.slip).norm(), event.roll);
}

score::Stroke::Kind kind_of(const ContactEvent& event) {
  return event.roll > vector_of(event.slip).norm() ? score::Stroke::Kind::roll : score::Stroke::Kind::scrape;
}

}  // namespace

ContactSounds::ContactSounds(std::vector<Surface> surfaces, std::vector<double> masses, int rate,
                             std::size_t most_strokes, std::uint64_t seed)
    : surfaces_(std::move(surfaces)),
      masses_(std::move(masses)),
      rate_(rate),
      most_strokes_(most_strokes),
      random_(seed) {}

/// Of both bodies as one that hits a wall: their turning is left out.
double ContactSounds::mass_of(const ContactEvent& event) const {
  if (event.mass > 0.0) {
    return event.mass;
  }
  double inverse = 0.0;
  for (const std::int32_t body : event.bodies) {
    inverse += body == ContactEvent::nobody ? 0.0 : 1.0 / masses_[static_cast<std::size_t>(body)];
  }
  return 1.0 / inverse;
}

std::vector<ContactForce> ContactSounds::step(std::span<const ContactEvent> events, std::int64_t start,
                                              double duration) {
  start_ = start;
  duration_ = duration;
  gather(events);
  std::vector<ContactForce> forces;
  for (auto& [number, contact] : contacts_) {
    const auto [impact, load] = contact.track.follow(contact.last.impulse, duration);
    if (impact > 0.0) {
      add_impact(contact, impact, forces);
    }
    lead_stroke(contact, load);
    add_stroke(contact, forces);
  }
  std::erase_if(contacts_, [](const auto& entry) {
    return !entry.second.stroke && entry.second.track.silence() > forgotten_after;
  });
  return forces;
}

void ContactSounds::join(std::size_t body, double mass) {
  masses_.resize(std::max(masses_.size(), body + 1));
  masses_[body] = mass;
}

void ContactSounds::leave(std::size_t body) {
  for (auto& [number, contact] : contacts_) {
    if (std::ranges::find(contact.last.bodies, static_cast<std::int32_t>(body)) != contact.last.bodies.end()) {
      contact.track = {};
      contact.last.slip = {};
      contact.last.roll = 0.0;
    }
  }
}

/// One event of each contact: impulses of a step are added up.
void ContactSounds::gather(std::span<const ContactEvent> events) {
  for (auto& [number, contact] : contacts_) {
    contact.last.impulse = 0.0;
  }
  for (const ContactEvent& event : events) {
    const double impulse = event.phase == ContactEvent::Phase::end ? 0.0 : event.impulse;
    ContactEvent& last = contacts_[event.contact].last;
    const double sum = last.impulse + impulse;
    if (impulse > 0.0) {
      last = event;
    }
    last.impulse = sum;
  }
}

void ContactSounds::add_impact(const Contact& contact, double impulse, std::vector<ContactForce>& forces) {
  const ContactEvent& event = contact.last;
  const double mass = mass_of(event);
  if (impulse < 2.0 * mass * slowest_impact) {
    return;
  }
  const double share = event.moment >= 0.0 ? event.moment : static_cast<double>(random_() >> 11U) * 0x1p-53;
  const resonators::HertzPulse pulse(
      impact_of(impulse, mass, surfaces_[event.surfaces[0]], surfaces_[event.surfaces[1]]));
  const auto force = [&](double time) { return pulse.at(time); };
  forces.push_back({.bodies = event.bodies,
                    .force = {.start = start_ + std::llround(share * duration_ * rate_),
                              .at = vector_of(event.point),
                              .direction = vector_of(event.normal),
                              .force = resonators::sampled(force, pulse.duration, rate_)},
                    .impulse = impulse});
  ++impacts_;
}

void ContactSounds::lead_stroke(Contact& contact, double load) {
  const double speed = speed_of(contact.last);
  if (contact.stroke) {
    contact.stroke->lead(speed, load);
    if (load == 0.0 || speed < slowest_stroke) {
      contact.stroke->end();
    }
    return;
  }
  if (load == 0.0 || speed < slowest_stroke) {
    contact.is_refused = false;
    return;
  }
  if (strokes_ >= most_strokes_) {
    left_out_ += contact.is_refused ? 0 : 1;
    contact.is_refused = true;
    return;
  }
  const ContactEvent& event = contact.last;
  score::Stroke stroke =
      stroke_of(kind_of(event), mass_of(event), surfaces_[event.surfaces[0]], surfaces_[event.surfaces[1]]);
  stroke.speed = speed;
  stroke.load = load;
  contact.stroke.emplace(stroke, random_(), rate_, start_);
  ++strokes_;
}

/// All pieces that begin before the step is over. Friction acts against the slip.
void ContactSounds::add_stroke(Contact& contact, std::vector<ContactForce>& forces) {
  if (!contact.stroke) {
    return;
  }
  const ContactEvent& event = contact.last;
  const Vector3 slip = vector_of(event.slip);
  const bool slides = kind_of(event) == score::Stroke::Kind::scrape && slip.norm() > 0.0;
  const double friction = std::sqrt(surfaces_[event.surfaces[0]].friction * surfaces_[event.surfaces[1]].friction);
  const Vector3 drag = slides ? Vector3(friction * slip.normalized()) : Vector3::Zero();
  while (contact.stroke->is_due(start_ + std::llround(duration_ * rate_))) {
    LedStroke::Piece piece = contact.stroke->next(start_);
    forces.push_back({.bodies = event.bodies,
                      .force = {.start = piece.start,
                                .at = vector_of(event.point),
                                .direction = vector_of(event.normal) - drag,
                                .force = std::move(piece.force)},
                      .impulse = std::numeric_limits<double>::infinity()});
  }
  if (contact.stroke->is_over()) {
    contact.stroke.reset();
    --strokes_;
  }
}

}  // namespace idiophone::touching
