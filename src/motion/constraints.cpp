#include "idiophone/motion/constraints.hpp"

#include <Eigen/Geometry>
#include <algorithm>

namespace idiophone::motion {

Constraints::Pose Constraints::Group::at(double time) const {
  if (!path.moves()) {
    return {Eigen::Matrix3d::Zero(), Vector3::Zero(), Vector3::Zero()};
  }
  const double factor = path.signal.at(time);
  const Eigen::AngleAxisd rotation(factor * path.rotation.norm(), path.rotation.normalized());
  return {rotation.toRotationMatrix() - Eigen::Matrix3d::Identity(), path.pivot, factor * path.displacement};
}

template <class Visitor>
void Constraints::for_each_component(const Group& group, double time, Visitor visit) {
  const Pose pose = group.at(time);
  for (std::size_t n = 0; n < group.nodes.size(); ++n) {
    const Vector3 displacement = pose.turn * (group.reference[n] - pose.pivot) + pose.shift;
    for (int i = 0; i < 3; ++i) {
      if (group.path.axes[static_cast<std::size_t>(i)]) {
        visit(group.nodes[n], i, displacement[i]);
      }
    }
  }
}

Constraints::Constraints(const scene::Scene& scene, const mesh::Part& part, const Attachments& attachments) {
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const auto& body = scene.bodies[b];
    // Driven groups come last, so a node in a fixed and in a driven group is driven: the seam of a clamp that moves.
    for (std::size_t i = 0; i < body.fixed.size(); ++i) {
      scene::DrivenGroup still;
      still.axes = body.fixed[i].axes;
      add(still, attachments.bodies[b].fixed[i], part);
    }
    for (std::size_t i = 0; i < body.driven.size(); ++i) {
      add(body.driven[i], attachments.bodies[b].driven[i], part);
    }
  }
}

void Constraints::add(const scene::DrivenGroup& path, const mesh::Patch& patch, const mesh::Part& part) {
  Group group{owned(patch, part).nodes, {}, path};
  std::ranges::transform(group.nodes, std::back_inserter(group.reference),
                         [&](Index node) { return part.reference[static_cast<std::size_t>(node)]; });
  groups_.push_back(std::move(group));
}

void Constraints::place(double time, solid::NodeState* state) const {
  for (const Group& group : groups_) {
    for_each_component(group, time, [&](Index node, int i, double displacement) {
      state[node].displacement[i] = displacement;
      state[node].velocity[i] = 0.0;
    });
  }
}

void Constraints::steer(double arrival, double step, std::span<const double> mass, solid::NodeState* state,
                        ReproducibleSum& work) const {
  for (const Group& group : groups_) {
    std::vector<double> before;  // a step ago, m
    if (group.path.moves()) {
      for_each_component(group, std::max(0.0, arrival - 2 * step), [&](Index, int, double u) { before.push_back(u); });
    }
    std::size_t component = 0;
    for_each_component(group, arrival, [&](Index node, int i, double displacement) {
      solid::NodeState& now = state[node];
      const double free = now.velocity[i];
      const double velocity = (displacement - now.displacement[i]) / step;
      now.velocity[i] = velocity;
      if (group.path.moves()) {
        // The drive's impulse, what the velocity differs by from what it would be, times the mean of the old and new.
        const double old = (now.displacement[i] - before[component++]) / step;
        work.add(mass[static_cast<std::size_t>(node)] * (velocity - free) * (old + velocity) / 2);
      }
    });
  }
}

std::vector<Index> Constraints::held_components() const {
  std::vector<Index> held;
  for (const Group& group : groups_) {
    for_each_component(group, 0.0, [&](Index node, int i, double) { held.push_back(3 * node + i); });
  }
  std::ranges::sort(held);
  held.erase(std::unique(held.begin(), held.end()), held.end());
  return held;
}

}  // namespace idiophone::motion
