#include "idiophone/solids/motion/surface_load.hpp"

#include <Eigen/Geometry>
#include <array>

#include "idiophone/foundation/each_once.hpp"

namespace idiophone::motion {

namespace {

Vector3 displacement(const solid::NodeState& node) {
  return Vector3(node.displacement);
}

Vector3 velocity(const solid::NodeState& node) {
  return Vector3(node.velocity);
}

/// Displacements or velocities along a normal: the values at the corners of the linear function. Sums in the order of
/// the nodes, which is the same on any rank.
template <class Quantity>
std::array<double, 3> at_corners(const LoadedTriangle& triangle, const Vector3& normal,
                                 std::span<const solid::NodeState> state, const Quantity& quantity) {
  std::array<double, 3> values{};
  const double* shapes = triangle.shapes->data();
  for (const Index node : triangle.nodes) {
    const double along = normal.dot(quantity(state[node]));
    for (double& value : values) {
      value += *shapes++ * along;
    }
  }
  return values;
}

/// Ascending, each once.
std::vector<Index> nodes_of(const std::vector<LoadedTriangle>& triangles) {
  std::vector<Index> nodes;
  for (const LoadedTriangle& triangle : triangles) {
    nodes.insert(nodes.end(), triangle.nodes.begin(), triangle.nodes.end());
  }
  keep_each_once(nodes);
  return nodes;
}

}  // namespace

SurfaceLoad::SurfaceLoad(LoadedTriangles triangles, std::span<const Vector3> reference, double interval)
    : triangles_(std::move(triangles)),
      nodes_(nodes_of(loaded())),
      reference_(reference),
      interval_(interval),
      normal_(loaded().size()),
      displaced_(3 * loaded().size()),
      velocity_(3 * loaded().size()),
      force_(3 * loaded().size()),
      resistance_(3 * loaded().size()),
      whole_(3 * loaded().size()),
      now_(3 * loaded().size()) {}

void SurfaceLoad::start(std::span<const solid::NodeState> state) {
  find_geometry(state);
  for (std::size_t t = 0; t < loaded().size(); ++t) {
    std::ranges::copy(at_corners(loaded()[t], normal_[t], state, velocity), &velocity_[3 * t]);
  }
}

void SurfaceLoad::find_geometry(std::span<const solid::NodeState> state) {
  const auto place = [&](Index node) -> Vector3 { return reference_[node] + displacement(state[node]); };
  for (std::size_t t = 0; t < loaded().size(); ++t) {
    const auto& [a, b, c] = loaded()[t].corners;
    normal_[t] = (place(b) - place(a)).cross(place(c) - place(a)).normalized();
    std::ranges::copy(at_corners(loaded()[t], normal_[t], state, displacement), &displaced_[3 * t]);
  }
}

void SurfaceLoad::begin_interval(std::span<const solid::NodeState> state) {
  find_geometry(state);
  for (std::size_t i = 0; i < whole_.size(); ++i) {
    const LinearForce before = whole_[i];
    whole_[i] = {force_[i] - resistance_[i] * velocity_[i], resistance_[i]};
    now_[i] = {(before.constant + whole_[i].constant) / 2.0, (before.resistance + whole_[i].resistance) / 2.0};
  }
}

void SurfaceLoad::end_interval(std::span<const solid::NodeState> state, std::span<double> changes) {
  for (std::size_t t = 0; t < loaded().size(); ++t) {
    const std::array<double, 3> displaced = at_corners(loaded()[t], normal_[t], state, displacement);
    for (std::size_t i = 3 * t; i < 3 * t + 3; ++i) {
      const double velocity = (displaced.at(i - 3 * t) - displaced_[i]) / interval_;
      changes[i] = velocity - velocity_[i];
      velocity_[i] = velocity;
    }
  }
}

void SurfaceLoad::add(std::span<const solid::NodeState> state, std::span<solid::NodeForce> force) const {
  for (std::size_t t = 0; t < loaded().size(); ++t) {
    std::array<double, 3> pushes = at_corners(loaded()[t], normal_[t], state, velocity);
    for (std::size_t k = 0; k < 3; ++k) {
      const LinearForce& now = now_[3 * t + k];
      pushes.at(k) = now.constant + now.resistance * pushes.at(k);
    }
    const double* shapes = loaded()[t].shapes->data();
    for (const Index node : loaded()[t].nodes) {
      const double push = shapes[0] * pushes[0] + shapes[1] * pushes[1] + shapes[2] * pushes[2];
      shapes += 3;
      for (int i = 0; i < 3; ++i) {
        force[node].component[i] -= push * normal_[t][i];
      }
    }
  }
}

void SurfaceLoad::archive(parallel::Archive& archive, const parallel::Rows& triangles,
                          std::span<const solid::NodeState> state) {
  archive.rows("motion/surface_load", triangles, [this](std::size_t t, parallel::ArchiveRow& row) {
    for (std::size_t i = 3 * t; i < 3 * t + 3; ++i) {
      row.value(velocity_[i]);
      for (LinearForce* const linear : {&whole_[i], &now_[i]}) {
        row.value(linear->constant);
        row.value(linear->resistance);
      }
    }
  });
  if (archive.restoring()) {
    find_geometry(state);
  }
}

}  // namespace idiophone::motion
