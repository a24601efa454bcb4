#pragma once
// A body whose modes are numbers, and what touches it.

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "idiophone/instruments/resonators/point_contacts.hpp"
#include "rate.hpp"

namespace idiophone::resonators {

struct TouchedMode {
  double frequency;      ///< Hz
  double decay;          ///< 1/s
  double participation;  ///< 1/sqrt(kg), at the point, in the direction of the force
};

/// A contact that remembers how the body moved.
class Witness : public Contact {
 public:
  explicit Witness(Contact& contact) : contact_(contact) {}

  [[nodiscard]] double force(double free, double compliance) const override { return contact_.force(free, compliance); }
  void advance(double way, double force) override {
    contact_.advance(way, force);
    velocity.push_back(way * rate);
    force_on_body.push_back(force);
  }

  std::vector<double> velocity;       ///< of the point, mean of each sample, m/s
  std::vector<double> force_on_body;  ///< in each sample, N

 private:
  Contact& contact_;
};

/// Heard by nobody.
class TouchedBody {
 public:
  TouchedBody(const std::vector<TouchedMode>& modes, Contact& contact)
      : witness_(contact), bank_(turns(modes)), gains_(bank_.groups()), contacts_(rate) {
    std::vector<Complex> displacement, by_mean;
    for (const TouchedMode& mode : modes) {
      const Resonator resonator(DampedOscillator(mode.frequency, mode.decay), rate);
      displacement.push_back(mode.participation * resonator.displacement);
      by_mean.push_back(mode.participation * resonator.by_mean);
    }
    point_ = {.displacement = in_groups(displacement), .by_mean = in_groups(by_mean), .by_slope = {}, .lowest = 1e3};
    point_.by_slope.resize(bank_.groups());
    contacts_.add(witness_, point_);
  }

  /// Another contact at the same point.
  void add(Contact& contact) { contacts_.add(contact, point_); }

  /// The modes get states at once, [modes] z, m sqrt(kg)/s.
  void start(std::span<const Complex> states) {
    const std::vector<ModeGroup> first = in_groups(states), none(bank_.groups());
    const std::vector<ForcePiece> impulse = {{.mean = 1.0}};
    std::vector<double> sound(1);
    bank_.advance(std::vector<Drive>{{.force = impulse, .by_mean = first, .by_slope = none}}, gains_, 1, sound);
  }

  void advance(std::size_t samples) {
    std::vector<double> sound(ResonatorBank::most_samples);
    while (samples > 0) {
      const std::size_t count = std::min(samples, sound.size());
      bank_.advance({}, contacts_, gains_, 1, std::span(sound).first(count));
      samples -= count;
    }
  }

  /// Of undamped modes, J.
  [[nodiscard]] double energy() const {
    double sum = 0.0;
    for (std::size_t mode = 0; mode < bank_.groups() * modes_in_group; ++mode) {
      sum += 0.5 * std::norm(bank_.state(mode));
    }
    return sum;
  }

  /// Of the point, mean of each sample, m/s.
  [[nodiscard]] const std::vector<double>& velocity() const { return witness_.velocity; }
  /// Of the first contact in each sample, N.
  [[nodiscard]] const std::vector<double>& force() const { return witness_.force_on_body; }

 private:
  static std::vector<Complex> turns(const std::vector<TouchedMode>& modes) {
    std::vector<Complex> turns;
    for (const TouchedMode& mode : modes) {
      turns.push_back(Resonator(DampedOscillator(mode.frequency, mode.decay), rate).turn);
    }
    return turns;
  }

  Witness witness_;
  ResonatorBank bank_;
  std::vector<ModeGroup> gains_;
  ContactPoint point_;
  PointContacts contacts_;
};

}  // namespace idiophone::resonators
