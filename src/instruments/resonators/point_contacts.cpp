#include <algorithm>
#include <cassert>
#include <cmath>

#include "idiophone/instruments/resonators/contact.hpp"
#include "mode_groups.hpp"

namespace idiophone::resonators {

void PointContacts::add(Contact& contact, const ContactPoint& point) {
  assert(touches_.size() < most);
  touches_.push_back({.contact = &contact, .point = &point, .rise = SmoothRise(point.lowest, 1.0 / rate_)});
  find_compliance();
}

void PointContacts::remove(const Contact& contact) {
  std::erase_if(touches_, [&](const Touch& touch) { return touch.contact == &contact; });
  find_compliance();
}

void PointContacts::find_compliance() {
  for (std::size_t i = 0; i < touches_.size(); ++i) {
    for (std::size_t j = 0; j < touches_.size(); ++j) {
      ModePack sum{};
      for (std::size_t group = 0; group < touches_[i].point->displacement.size(); ++group) {
        sum = with_sound(sum, touches_[i].point->displacement[group], touches_[j].point->by_mean[group]);
      }
      compliance_[i][j] = sum_of_lanes(sum);
    }
  }
  forces_ = {};
}

double PointContacts::compliance(std::span<const double> yields, std::size_t touch, std::size_t other) const {
  return compliance_[touch][other] - yields[touch] * yields[other];
}

double PointContacts::way(std::span<const double> free, std::span<const double> yields, std::size_t touch) const {
  double sum = free[touch];
  for (std::size_t other = 0; other < touches_.size(); ++other) {
    sum += compliance(yields, touch, other) * forces_[other];
  }
  return sum;
}

std::span<const double> PointContacts::advance(std::span<const double> free, std::span<const double> yields,
                                               std::size_t sample) {
  constexpr int most_rounds = 100;
  constexpr double rounding = 1e-15;
  bool changes = true;
  for (int round = 0; round < most_rounds && changes; ++round) {
    changes = false;
    for (std::size_t i = 0; i < touches_.size(); ++i) {
      const double own = compliance(yields, i, i);
      const double force = touches_[i].contact->force(way(free, yields, i) - own * forces_[i], own);
      changes |= touches_.size() > 1 && std::abs(force - forces_[i]) > rounding * std::abs(force);
      forces_[i] = force;
    }
  }
  for (std::size_t i = 0; i < touches_.size(); ++i) {
    touches_[i].contact->advance(way(free, yields, i), forces_[i]);
    keep(touches_[i], forces_[i], sample);
  }
  return std::span(forces_).first(touches_.size());
}

void PointContacts::keep(Touch& touch, double force, std::size_t sample) const {
  const double begin = 0.5 * (touch.before + force);
  touch.pieces[sample] = {.mean = force, .begin = begin, .rise = touch.rise.at(begin) / rate_};
  touch.rise.advance(force, force);
  touch.before = force;
}

}  // namespace idiophone::resonators
