#pragma once
// Bodies whose modes are numbers, and that touch each other.

#include <algorithm>
#include <list>
#include <span>
#include <vector>

#include "idiophone/instruments/resonators/bodies_in_contact.hpp"
#include "touched_body.hpp"

namespace idiophone::resonators {

/// Heard by nobody.
class TouchingBodies {
 public:
  /// @param bodies  [bodies][modes]
  explicit TouchingBodies(std::vector<std::vector<TouchedMode>> bodies)
      : bodies_(std::move(bodies)), contacts_(rate, bodies_.size(), PointContacts::most_staying) {
    for (const std::vector<TouchedMode>& modes : bodies_) {
      std::vector<Complex> turns;
      for (const TouchedMode& mode : modes) {
        turns.push_back(Resonator(DampedOscillator(mode.frequency, mode.decay), rate).turn);
      }
      banks_.emplace_back(turns);
    }
  }

  /// A point at which the participations of the modes are so many times as large.
  struct Place {
    std::size_t body;
    std::vector<double> times{1.0};  ///< [modes] after the last one as the last one
  };
  void add(Contact& contact, const std::vector<Place>& places) {
    std::vector<TouchedPoint> points;
    for (const Place& place : places) {
      points.push_back({.body = place.body, .point = &points_.emplace_back(point(place))});
    }
    contacts_.add(contact, points);
  }

  /// Advances by a sample. @param impulse  where the participations are those of the body, N s
  void push(std::size_t body, double impulse) {
    const ContactPoint at = point({.body = body});
    const std::vector<ForcePiece> force(1, {.mean = impulse * rate});
    const Drive drive{.force = force, .by_mean = at.by_mean, .by_slope = at.by_slope};
    advance_block(1, body, {&drive, 1});
  }

  void advance(std::size_t samples) {
    while (samples > 0) {
      const std::size_t count = std::min(samples, ResonatorBank::most_samples);
      advance_block(count, 0, {});
      samples -= count;
    }
  }

  /// Of the first mode where its participation is that of the body, m/s.
  [[nodiscard]] double velocity(std::size_t body) const {
    return banks_[body].state(0).real() * bodies_[body].front().participation;
  }

  /// Of the undamped modes of all bodies, J.
  [[nodiscard]] double energy() const {
    double sum = 0.0;
    for (const ResonatorBank& bank : banks_) {
      for (std::size_t mode = 0; mode < bank.groups() * modes_in_group; ++mode) {
        sum += 0.5 * std::norm(bank.state(mode));
      }
    }
    return sum;
  }

 private:
  void advance_block(std::size_t samples, std::size_t driven, std::span<const Drive> drives) {
    const std::vector<ModeGroup> gains(std::ranges::max_element(banks_, {}, &ResonatorBank::groups)->groups());
    std::vector<double> sound(samples);
    std::vector<BodyInContact> all;
    for (ResonatorBank& bank : banks_) {
      all.push_back({.bank = &bank, .drives = {}, .gains = gains, .outputs = 1, .sound = sound});
    }
    all[driven].drives = drives;
    advance_together(all, contacts_);
  }

  [[nodiscard]] ContactPoint point(const Place& place) const {
    std::vector<Complex> displacement, by_mean;
    for (const TouchedMode& mode : bodies_[place.body]) {
      const double times = place.times[std::min(displacement.size(), place.times.size() - 1)];
      const Resonator resonator(DampedOscillator(mode.frequency, mode.decay), rate);
      displacement.push_back(times * mode.participation * resonator.displacement);
      by_mean.push_back(times * mode.participation * resonator.by_mean);
    }
    ContactPoint made{
        .displacement = in_groups(displacement), .by_mean = in_groups(by_mean), .by_slope = {}, .lowest = 1e3};
    made.by_slope.resize(made.by_mean.size());
    return made;
  }

  std::vector<std::vector<TouchedMode>> bodies_;
  std::vector<ResonatorBank> banks_;
  std::list<ContactPoint> points_;
  PointContacts contacts_;
};

}  // namespace idiophone::resonators
