#include "idiophone/run/bodies/body_channels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace idiophone::bodies {

namespace {

using motion::BodyMotion;

std::vector<double> numbers(const Vector3& vector) {
  return {vector.begin(), vector.end()};
}

std::vector<double> numbers(const Eigen::Quaterniond& quaternion) {
  return {quaternion.w(), quaternion.x(), quaternion.y(), quaternion.z()};
}

/// One channel of every body.
struct BodyChannel {
  std::string name;
  std::string unit;
  std::vector<std::string> columns;
  std::string description;
  std::vector<double> (*row)(const BodyMotion&);
};

const std::vector<BodyChannel>& body_channels() {
  static const std::vector<BodyChannel> all = {
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

/// Of the bodies, then of their pieces: those of BODY are BODY.1, BODY.2, ...
std::vector<std::string> names(const Preparation& ready) {
  std::vector<std::string> all;
  std::ranges::transform(ready.scene.bodies, std::back_inserter(all), &scene::Body::name);
  std::vector<int> pieces(all.size());
  for (const motion::Piece& piece : ready.initial_state.pieces) {
    all.push_back(fmt::format("{}.{}", all[piece.body], ++pieces[piece.body]));
  }
  return all;
}

/// Whether joints have a column among the energies.
bool has_joints(const Preparation& ready) {
  return !ready.scene.joints.empty();
}

/// Energies first, then all channels of each body and piece.
std::vector<spectra::Series> body_series(const Preparation& ready) {
  std::vector<spectra::Series> all = {
      {"/energy",
       "J",
       0.0,
       {"kinetic", "elastic", "contact", "gravitational", "work"},
       "energies of all bodies and contacts, and the work done on them by pulses, winds, bows and driven groups",
       {}}};
  if (has_joints(ready)) {
    all.front().columns.emplace_back("joints");
  }
  for (const std::string& name : names(ready)) {
    for (const BodyChannel& channel : body_channels()) {
      all.push_back(
          {"/motion/" + name + "/" + channel.name, channel.unit, 0.0, channel.columns, channel.description, {}});
    }
  }
  return all;
}

/// Of the two quaternions of one rotation, the one closer to the other's.
Eigen::Quaterniond closer(Eigen::Quaterniond quaternion, const Eigen::Quaterniond& other) {
  if (quaternion.dot(other) < 0) {
    quaternion.coeffs() *= -1;
  }
  return quaternion;
}

}  // namespace

BodyChannels::BodyChannels(const Preparation& ready, motion::Motion& motion, MPI_Comm communicator)
    : MotionRateChannels(ready.scene, body_series(ready)),
      ready_(ready),
      motion_(motion),
      communicator_(communicator),
      orientations_(names(ready).size(), Eigen::Quaterniond::Identity()) {}

void BodyChannels::note_row() {
  extend(words_, observation_words(ready_, motion_));
}

std::vector<std::vector<double>> BodyChannels::collect() {
  std::vector<std::vector<double>> series(channels().size());
  if (words_.empty()) {
    return series;
  }
  const std::vector<std::int64_t> sums = sum_over_ranks(words_, communicator_);
  words_.clear();
  const std::size_t width = words_per_observation(ready_);
  for (std::size_t first = 0; first < sums.size(); first += width) {
    Observation seen = observation(ready_, std::span(sums).subspan(first, width));
    auto next = series.begin();
    extend(*next, {seen.kinetic(), seen.elastic(), seen.contact, seen.gravitational, seen.work});
    if (has_joints(ready_)) {
      next->push_back(seen.joint);
    }
    ++next;
    extend(seen.bodies, seen.pieces);
    for (std::size_t b = 0; b < seen.bodies.size(); ++b) {
      orientations_[b] = seen.bodies[b].orientation = closer(seen.bodies[b].orientation, orientations_[b]);
      for (const BodyChannel& channel : body_channels()) {
        extend(*next++, channel.row(seen.bodies[b]));
      }
    }
  }
  return series;
}

void BodyChannels::archive(parallel::Archive& archive) {
  std::vector<double> all;
  for (const Eigen::Quaterniond& orientation : orientations_) {
    extend(all, numbers(orientation));
  }
  archive.root("motion/orientations", all);
  for (std::size_t b = 0; b < orientations_.size(); ++b) {
    orientations_[b] = {all.at(4 * b), all.at(4 * b + 1), all.at(4 * b + 2), all.at(4 * b + 3)};
  }
}

}  // namespace idiophone::bodies
