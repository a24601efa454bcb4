#include "idiophone/source/body_notes.hpp"

#include <algorithm>
#include <cmath>

namespace idiophone::source {

namespace {

using motion::BodyMotion;

std::vector<double> numbers(const Vector3& vector) {
  return {vector.begin(), vector.end()};
}

std::vector<double> numbers(const Eigen::Quaterniond& quaternion) {
  return {quaternion.w(), quaternion.x(), quaternion.y(), quaternion.z()};
}

/// One series of every body.
struct Channel {
  std::string name;
  std::string unit;
  std::vector<std::string> columns;
  std::string description;
  std::vector<double> (*row)(const BodyMotion&);
};

const std::vector<Channel>& channels() {
  static const std::vector<Channel> all = {
      {"centre_of_mass",
       "m",
       {"x", "y", "z"},
       "position of the centre of mass",
       [](const BodyMotion& body) { return numbers(body.centre); }},
      {"velocity",
       "m/s",
       {"x", "y", "z"},
       "velocity of the centre of mass",
       [](const BodyMotion& body) { return numbers(body.velocity); }},
      {"orientation",
       "1",
       {"w", "x", "y", "z"},
       "unit quaternion of the rotation that takes the undeformed body closest to the deformed one",
       [](const BodyMotion& body) { return numbers(body.orientation); }},
      {"angular_velocity",
       "rad/s",
       {"x", "y", "z"},
       "angular momentum over the inertia tensor of the deformed body, about the centre of mass",
       [](const BodyMotion& body) { return numbers(body.angular_velocity); }},
      {"angular_momentum",
       "kg m2/s",
       {"x", "y", "z"},
       "angular momentum about the centre of mass",
       [](const BodyMotion& body) { return numbers(body.angular_momentum); }},
      {"energy", "J", {"kinetic", "elastic"}, "energies of the body", [](const BodyMotion& body) {
         return std::vector{body.kinetic, body.elastic};
       }}};
  return all;
}

template <class Value>
void extend(std::vector<Value>& values, const std::vector<Value>& more) {
  values.insert(values.end(), more.begin(), more.end());
}

std::string path(const scene::Body& body, const Channel& channel) {
  return "/motion/" + body.name + "/" + channel.name;
}

/// Of the two quaternions of one rotation, the one closer to the other's.
Eigen::Quaterniond closer(Eigen::Quaterniond quaternion, const Eigen::Quaterniond& other) {
  if (quaternion.dot(other) < 0) {
    quaternion.coeffs() *= -1;
  }
  return quaternion;
}

}  // namespace

BodyNotes::BodyNotes(const Preparation& ready, MPI_Comm communicator)
    : ready_(ready),
      communicator_(communicator),
      orientations_(ready.scene.bodies.size(), Eigen::Quaterniond::Identity()) {
  const double wanted = ready.scene.output.motion_per_second;
  stride_ = wanted > 0 ? std::max<std::int64_t>(1, std::llround(ready.scene.audio.rate / wanted)) : 0;
}

void BodyNotes::declare(store::ResultFile& result) const {
  if (stride_ == 0) {
    return;
  }
  const double rate = static_cast<double>(ready_.scene.audio.rate) / static_cast<double>(stride_);
  result.declare({"/energy",
                  "J",
                  rate,
                  {"kinetic", "elastic", "contact", "gravitational", "work"},
                  "energies of all bodies and contacts, and the work done on them by pulses and driven groups",
                  {}});
  for (const auto& body : ready_.scene.bodies) {
    for (const Channel& channel : channels()) {
      result.declare({path(body, channel), channel.unit, rate, channel.columns, channel.description, {}});
    }
  }
}

void BodyNotes::note(std::int64_t sample, motion::Motion& motion) {
  if (stride_ > 0 && sample % stride_ == 0) {
    extend(notes_, observation_words(ready_, motion));
  }
}

void BodyNotes::write(store::ResultFile& result) {
  if (notes_.empty()) {
    return;
  }
  const std::vector<std::int64_t> sums = sum_over_ranks(notes_, communicator_);
  notes_.clear();
  const std::vector<scene::Body>& bodies = ready_.scene.bodies;
  std::vector<double> energies;
  std::vector<std::vector<double>> series(bodies.size() * channels().size());
  const std::size_t width = words_per_observation(ready_);
  for (std::size_t first = 0; first < sums.size(); first += width) {
    Observation seen = observation(ready_, std::span(sums).subspan(first, width));
    extend(energies, {seen.kinetic(), seen.elastic(), seen.contact, seen.gravitational, seen.work});
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      orientations_[b] = seen.bodies[b].orientation = closer(seen.bodies[b].orientation, orientations_[b]);
      for (std::size_t c = 0; c < channels().size(); ++c) {
        extend(series[b * channels().size() + c], channels()[c].row(seen.bodies[b]));
      }
    }
  }
  result.append("/energy", energies);
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    for (std::size_t c = 0; c < channels().size(); ++c) {
      result.append(path(bodies[b], channels()[c]), series[b * channels().size() + c]);
    }
  }
}

std::vector<double> BodyNotes::save() const {
  std::vector<double> all;
  for (const Eigen::Quaterniond& orientation : orientations_) {
    extend(all, numbers(orientation));
  }
  return all;
}

void BodyNotes::restore(std::span<const double> orientations) {
  for (std::size_t b = 0; b < orientations_.size(); ++b) {
    const auto one = orientations.subspan(4 * b, 4);
    orientations_[b] = {one[0], one[1], one[2], one[3]};
  }
}

}  // namespace idiophone::source
