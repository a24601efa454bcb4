#include "idiophone/solids/motion/wind.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <random>
#include <unordered_map>

#include "idiophone/foundation/each_once.hpp"

namespace idiophone::motion {

WindVelocity::WindVelocity(const scene::Wind& wind)
    : mean_(wind.velocity),
      signal_(wind.signal),
      amplitude_(wind.gusts.intensity * wind.velocity.norm() * std::sqrt(2.0 / waves)) {
  if (amplitude_ == 0.0) {
    return;
  }
  constexpr double pi = std::numbers::pi;
  std::mt19937_64 random(wind.gusts.seed);
  for (std::size_t k = 0; k < waves; ++k) {
    const double share = (static_cast<double>(k) + 0.5) / waves;
    Wave& wave = waves_.emplace_back(Wave{.rate = std::tan(pi / 2.0 * share) / wind.gusts.time, .phase = {}});
    for (double& phase : wave.phase) {
      phase = 2.0 * pi * static_cast<double>(random() >> 11U) * 0x1p-53;
    }
  }
}

Vector3 WindVelocity::at(double time) const {
  Vector3 velocity = mean_;
  for (const Wave& wave : waves_) {
    for (int i = 0; i < 3; ++i) {
      velocity[i] += amplitude_ * std::cos(wave.rate * time + wave.phase[i]);
    }
  }
  return signal_.at(time) * velocity;
}

Wind::Wind(const scene::Wind& wind, double air_density, std::span<const mesh::Triangle> triangles,
           const mesh::Part& part)
    : velocity_(wind),
      factor_(0.5 * air_density * wind.drag),
      reference_(part.reference),
      owned_nodes_(part.owned_nodes),
      remembered_(part.owned_nodes, Vector3::Zero()) {
  std::unordered_map<Index, Index> local;
  for (std::size_t node = 0; node < part.node_ids.size(); ++node) {
    local.emplace(part.node_ids[node], static_cast<Index>(node));
  }
  const auto is_owned = [&](Index node) {
    const auto found = local.find(node);
    return found != local.end() && found->second < owned_nodes_;
  };
  for (const mesh::Triangle& triangle : triangles) {
    if (!std::ranges::any_of(triangle, is_owned)) {
      continue;
    }
    auto& corners = triangles_.emplace_back();  // its element is computed here, and has all its nodes here
    std::ranges::transform(triangle, corners.begin(), [&](Index node) { return local.at(node); });
    std::ranges::copy_if(corners, std::back_inserter(nodes_), [&](Index node) { return node < owned_nodes_; });
  }
  keep_each_once(nodes_);
}

/// visit(node, force) for each owned corner of each triangle that faces the wind.
template <class Visit>
void Wind::visit_forces(double time, std::span<const NodeState> state, const Visit& visit) const {
  const Vector3 wind = velocity_.at(time);
  const auto place = [&](Index node) -> Vector3 { return reference_[node] + Vector3(state[node].displacement); };
  const auto velocity = [&](Index node) { return Vector3(state[node].velocity); };
  for (const auto& [a, b, c] : triangles_) {
    const Vector3 area = 0.5 * (place(b) - place(a)).cross(place(c) - place(a));  // A n, m2
    const Vector3 relative = wind - (velocity(a) + velocity(b) + velocity(c)) / 3.0;
    const double flow = relative.dot(area);  // m3/s, outwards
    if (!(flow < 0.0)) {
      continue;
    }
    const Vector3 at_corner = factor_ * relative.norm() * flow / (3.0 * area.norm()) * area;
    for (const Index node : {a, b, c}) {
      if (node < owned_nodes_) {
        visit(node, at_corner);
      }
    }
  }
}

void Wind::add(double time, std::span<const NodeState> state, std::span<NodeForce> force) const {
  visit_forces(time, state, [&](Index node, const Vector3& at_corner) {
    for (int i = 0; i < 3; ++i) {
      force[node].component[i] += at_corner[i];
    }
  });
}

void Wind::remember(double time, std::span<const NodeState> state) {
  for (const Index node : nodes_) {
    remembered_[node].setZero();
  }
  visit_forces(time, state, [&](Index node, const Vector3& at_corner) { remembered_[node] += at_corner; });
}

void Wind::add_work(const Step& step, std::span<const NodeState> state, ReproducibleSum& work) const {
  for (const Index node : nodes_) {
    work.add(step.length * remembered_[node].dot(Vector3(state[node].velocity)));
  }
}

std::array<ReproducibleSum, 3> Wind::total(double time, std::span<const NodeState> state) const {
  std::array<ReproducibleSum, 3> sums;
  visit_forces(time, state, [&](Index /*node*/, const Vector3& at_corner) {
    for (int i = 0; i < 3; ++i) {
      sums[i].add(at_corner[i]);
    }
  });
  return sums;
}

}  // namespace idiophone::motion
