#include "idiophone/instruments/resonators/point_contacts.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "mode_groups.hpp"

namespace idiophone::resonators {

namespace {

/// Way of the first point for a force at the second, both of one body, m/N.
double compliance_of(const ContactPoint& first, const ContactPoint& second) {
  ModePack sum{};
  for (std::size_t group = 0; group < first.displacement.size(); ++group) {
    sum = with_sound(sum, first.displacement[group], second.by_mean[group]);
  }
  return sum_of_lanes(sum);
}

}  // namespace

PointContacts::PointContacts(int rate, std::size_t bodies, std::size_t staying) : rate_(rate), sides_(bodies) {
  const std::size_t all = bodies * most + staying;
  touches_.reserve(all);
  for (std::vector<ContactSide>& sides : sides_) {
    sides.reserve(most + most_staying);
  }
  modes_compliance_.resize(all * all);
  compliance_.resize(all * all);
  free_.resize(all);
  forces_.resize(all);
  matrix_.resize(all * all);
  newton_forces_.resize(all);
}

void PointContacts::add(Contact& contact, std::span<const TouchedPoint> points) {
  assert(touches_.size() < forces_.size());
  for (const TouchedPoint& touched : points) {
    sides_[touched.body].push_back(
        {.contact = touches_.size(), .point = touched.point, .rise = SmoothRise(touched.point->lowest, 1.0 / rate_)});
  }
  touches_.push_back({.contact = &contact});
  find_compliance();
}

void PointContacts::remove(const Contact& contact) {
  const auto removed = std::ranges::find(touches_, &contact, &Touch::contact);
  if (removed == touches_.end()) {
    return;
  }
  const auto number = static_cast<std::size_t>(removed - touches_.begin());
  touches_.erase(removed);
  for (std::vector<ContactSide>& sides : sides_) {
    std::erase_if(sides, [&](const ContactSide& side) { return side.contact == number; });
    for (ContactSide& side : sides) {
      side.contact -= side.contact > number ? 1 : 0;
    }
  }
  find_compliance();
}

void PointContacts::find_compliance() {
  const std::size_t count = touches_.size();
  std::fill_n(modes_compliance_.begin(), count * count, 0.0);
  for (const std::vector<ContactSide>& sides : sides_) {
    for (const ContactSide& one : sides) {
      for (const ContactSide& other : sides) {
        modes_compliance_[one.contact * count + other.contact] += compliance_of(*one.point, *other.point);
      }
    }
  }
  std::ranges::fill(forces_, 0.0);
}

/// What the bodies say about the sample.
void PointContacts::gather() {
  const std::size_t count = touches_.size();
  std::copy_n(modes_compliance_.begin(), count * count, compliance_.begin());
  std::fill_n(free_.begin(), count, 0.0);
  for (const std::vector<ContactSide>& sides : sides_) {
    for (const ContactSide& one : sides) {
      free_[one.contact] += one.free;
      for (const ContactSide& other : sides) {
        compliance_[one.contact * count + other.contact] -= one.yield * other.yield;
      }
    }
  }
}

double PointContacts::way(std::size_t touch) const {
  const std::size_t count = touches_.size();
  double sum = free_[touch];
  for (std::size_t other = 0; other < count; ++other) {
    sum += compliance_[touch * count + other] * forces_[other];
  }
  return sum;
}

void PointContacts::advance(std::size_t sample) {
  gather();
  find_forces();
  for (std::size_t i = 0; i < touches_.size(); ++i) {
    touches_[i].contact->advance(way(i), forces_[i]);
  }
  keep(sample);
}

void PointContacts::keep(std::size_t sample) {
  for (std::vector<ContactSide>& sides : sides_) {
    for (ContactSide& side : sides) {
      const double force = forces_[side.contact];
      const double begin = 0.5 * (touches_[side.contact].before + force);
      side.pieces[sample] = {.mean = force, .begin = begin, .rise = side.rise.at(begin) / rate_};
      side.rise.advance(force, force);
    }
  }
  for (std::size_t i = 0; i < touches_.size(); ++i) {
    touches_[i].before = forces_[i];
  }
}

}  // namespace idiophone::resonators
