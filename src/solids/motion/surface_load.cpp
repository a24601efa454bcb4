#include "idiophone/solids/motion/surface_load.hpp"

#include <Eigen/Geometry>

#include "idiophone/foundation/each_once.hpp"

namespace idiophone::motion {

namespace {

Vector3 displacement(const solid::NodeState& node) {
  return Vector3(node.displacement);
}

/// The mean of three corners' displacements or velocities along a normal.
template <class Quantity>
double mean_along(const Vector3& normal, const std::array<Index, 3>& corners, const Quantity& quantity) {
  return normal.dot(quantity(corners[0]) + quantity(corners[1]) + quantity(corners[2])) / 3.0;
}

/// Ascending, each once.
std::vector<Index> corners_of(const std::vector<std::array<Index, 3>>& triangles) {
  std::vector<Index> corners;
  for (const auto& triangle : triangles) {
    corners.insert(corners.end(), triangle.begin(), triangle.end());
  }
  keep_each_once(corners);
  return corners;
}

}  // namespace

SurfaceLoad::SurfaceLoad(std::vector<std::array<Index, 3>> triangles, std::span<const Vector3> reference,
                         double interval)
    : triangles_(std::move(triangles)),
      nodes_(corners_of(triangles_)),
      reference_(reference),
      interval_(interval),
      normal_(triangles_.size()),
      displaced_(triangles_.size()),
      velocity_(triangles_.size()),
      force_(triangles_.size()),
      resistance_(triangles_.size()),
      whole_(triangles_.size()),
      now_(triangles_.size()) {}

void SurfaceLoad::start(std::span<const solid::NodeState> state) {
  find_geometry(state);
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    velocity_[t] = mean_along(normal_[t], triangles_[t], [&](Index node) { return Vector3(state[node].velocity); });
  }
}

void SurfaceLoad::find_geometry(std::span<const solid::NodeState> state) {
  const auto place = [&](Index node) -> Vector3 { return reference_[node] + displacement(state[node]); };
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    const auto& [a, b, c] = triangles_[t];
    normal_[t] = (place(b) - place(a)).cross(place(c) - place(a)).normalized();
    displaced_[t] = mean_along(normal_[t], triangles_[t], [&](Index node) { return displacement(state[node]); });
  }
}

void SurfaceLoad::begin_interval(std::span<const solid::NodeState> state) {
  find_geometry(state);
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    const LinearForce before = whole_[t];
    whole_[t] = {force_[t] - resistance_[t] * velocity_[t], resistance_[t]};
    now_[t] = {(before.constant + whole_[t].constant) / 2.0, (before.resistance + whole_[t].resistance) / 2.0};
  }
}

void SurfaceLoad::end_interval(std::span<const solid::NodeState> state, std::span<double> changes) {
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    const double displaced =
        mean_along(normal_[t], triangles_[t], [&](Index node) { return displacement(state[node]); });
    const double velocity = (displaced - displaced_[t]) / interval_;
    changes[t] = velocity - velocity_[t];
    velocity_[t] = velocity;
  }
}

void SurfaceLoad::add(std::span<const solid::NodeState> state, std::span<solid::NodeForce> force) const {
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    const double velocity =
        mean_along(normal_[t], triangles_[t], [&](Index node) { return Vector3(state[node].velocity); });
    const Vector3 at_corner = (now_[t].constant + now_[t].resistance * velocity) / 3.0 * normal_[t];
    for (const Index node : triangles_[t]) {
      for (int i = 0; i < 3; ++i) {
        force[node].component[i] -= at_corner[i];
      }
    }
  }
}

void SurfaceLoad::archive(parallel::Archive& archive, const parallel::Rows& triangles,
                          std::span<const solid::NodeState> state) {
  archive.rows("motion/surface_load", triangles, [this](std::size_t t, parallel::ArchiveRow& row) {
    row.value(velocity_[t]);
    for (LinearForce* const linear : {&whole_[t], &now_[t]}) {
      row.value(linear->constant);
      row.value(linear->resistance);
    }
  });
  if (archive.restoring()) {
    find_geometry(state);
  }
}

}  // namespace idiophone::motion
