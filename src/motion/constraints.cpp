#include "idiophone/motion/constraints.hpp"

#include <algorithm>

namespace idiophone::motion {

namespace {

/// Calls `visit` with each held axis.
template <class Visitor>
void for_each_axis(const scene::Axes& axes, Visitor visit) {
  for (int i = 0; i < 3; ++i) {
    if (axes[static_cast<std::size_t>(i)]) {
      visit(i);
    }
  }
}

}  // namespace

Vector3 Constraints::Group::at(double time) const {
  return displacement.isZero() ? Vector3(Vector3::Zero()) : Vector3(signal.at(time) * displacement);
}

Constraints::Constraints(const scene::Scene& scene, const mesh::Part& part, const Attachments& attachments) {
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const auto& body = scene.bodies[b];
    // Driven groups come last, so a node in a fixed and in a driven group is driven: the seam of a clamp that moves.
    for (std::size_t i = 0; i < body.fixed.size(); ++i) {
      groups_.push_back({owned(attachments.bodies[b].fixed[i], part).nodes, body.fixed[i].axes, Vector3::Zero(), {}});
    }
    for (std::size_t i = 0; i < body.driven.size(); ++i) {
      groups_.push_back({owned(attachments.bodies[b].driven[i], part).nodes, body.driven[i].axes,
                         body.driven[i].displacement, body.driven[i].signal});
    }
  }
}

void Constraints::place(double time, solid::NodeState* state) const {
  for (const Group& group : groups_) {
    const Vector3 place = group.at(time);
    for (const Index node : group.nodes) {
      for_each_axis(group.axes, [&](int i) {
        state[node].displacement[i] = place[i];
        state[node].velocity[i] = 0.0;
      });
    }
  }
}

void Constraints::steer(double arrival, double step, std::span<const double> mass, solid::NodeState* state,
                        ReproducibleSum& work) const {
  for (const Group& group : groups_) {
    const Vector3 place = group.at(arrival);
    for (const Index node : group.nodes) {
      for_each_axis(group.axes, [&](int i) {
        double& velocity = state[node].velocity[i];
        const double free = velocity;
        velocity = (place[i] - state[node].displacement[i]) / step;
        if (!group.displacement.isZero()) {
          work.add(mass[static_cast<std::size_t>(node)] * (velocity * velocity - free * free) / 2);
        }
      });
    }
  }
}

std::vector<Index> Constraints::held_components() const {
  std::vector<Index> held;
  for (const Group& group : groups_) {
    for (const Index node : group.nodes) {
      for_each_axis(group.axes, [&](int i) { held.push_back(3 * node + i); });
    }
  }
  std::ranges::sort(held);
  held.erase(std::unique(held.begin(), held.end()), held.end());
  return held;
}

}  // namespace idiophone::motion
