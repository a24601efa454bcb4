#include "idiophone/solids/motion/constraints.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <iterator>
#include <limits>
#include <map>

namespace idiophone::motion {

Constraints::RigidMotion Constraints::Group::at(double time) const {
  if (!path.moves()) {
    return {Eigen::Matrix3d::Zero(), Vector3::Zero(), Vector3::Zero()};
  }
  const double factor = path.signal.at(time);
  const Eigen::AngleAxisd rotation(factor * path.rotation.norm(), path.rotation.normalized());
  return {rotation.toRotationMatrix() - Eigen::Matrix3d::Identity(), path.pivot, factor * path.displacement};
}

template <class Visitor>
void Constraints::for_each_component(const Group& group, double time, Visitor visit) {
  const RigidMotion pose = group.at(time);
  for (std::size_t n = 0; n < group.nodes.size(); ++n) {
    const Vector3 displacement = pose.turn * (group.reference[n] - pose.pivot) + pose.shift;
    for (int i = 0; i < 3; ++i) {
      if (group.path.axes[i]) {
        visit(group.nodes[n], i, displacement[i]);
      }
    }
  }
}

Constraints::Constraints(const scene::Solids& solids, const mesh::Part& part, const Attachments& attachments) {
  for (std::size_t b = 0; b < solids.bodies.size(); ++b) {
    const auto& body = solids.bodies[b];
    Held& held = bodies_.emplace_back();
    // Driven groups come last, so a node in a fixed and in a driven group is driven: the seam of a clamp that moves.
    for (std::size_t i = 0; i < body.fixed.size(); ++i) {
      scene::DrivenGroup still;
      still.axes = body.fixed[i].axes;
      if (body.prestress && body.prestress->stretch && body.prestress->stretch->group == body.fixed[i].group) {
        still.displacement = body.prestress->stretch->displacement;
        still.signal.shape = scene::Signal::Shape::constant;
        still.signal.duration = std::numeric_limits<double>::infinity();
      }
      held.groups.push_back(group(still, attachments.bodies[b].fixed[i], part));
    }
    for (std::size_t i = 0; i < body.driven.size(); ++i) {
      held.groups.push_back(group(body.driven[i], attachments.bodies[b].driven[i], part));
    }
    number_components(held);
  }
}

Constraints::Group Constraints::group(const scene::DrivenGroup& path, const mesh::Patch& patch,
                                      const mesh::Part& part) {
  Group result{owned(patch, part).nodes, {}, path, {}};
  std::ranges::transform(result.nodes, std::back_inserter(result.reference),
                         [&](Index node) { return part.reference[node]; });
  return result;
}

void Constraints::number_components(Held& held) {
  std::map<Index, std::size_t> last_group;  // of each component
  for (std::size_t g = 0; g < held.groups.size(); ++g) {
    for_each_component(held.groups[g], 0.0, [&](Index node, int i, double) { last_group[3 * node + i] = g; });
  }
  for (const auto& [component, group] : last_group) {
    held.components.push_back(component);
  }
  held.at_rest.resize(held.components.size());
  for (std::size_t g = 0; g < held.groups.size(); ++g) {
    for_each_component(held.groups[g], 0.0, [&](Index node, int i, double) {
      const Index component = 3 * node + i;
      const auto place = std::ranges::lower_bound(held.components, component) - held.components.begin();
      held.groups[g].places.push_back(last_group.at(component) == g ? static_cast<Index>(place) : -1);
    });
  }
}

void Constraints::place(double time, std::span<solid::NodeState> state) const {
  for (const Held& held : bodies_) {
    for (const Group& group : held.groups) {
      for_each_component(group, time, [&](Index node, int i, double displacement) {
        state[node].displacement[i] = displacement;
        state[node].velocity[i] = 0.0;
      });
    }
  }
}

void Constraints::steer(std::size_t body, const Step& step, const solid::Mass& mass, std::span<solid::NodeState> state,
                        ReproducibleSum& work) const {
  const Held& held = bodies_[body];
  if (std::ranges::none_of(held.groups, [](const Group& group) { return group.path.moves(); })) {
    mass.impose(held.components, held.at_rest, state);  // they stay where `place` put them
    return;
  }
  std::vector<double> velocities = held.at_rest;
  for (const Group& group : held.groups) {
    if (!group.path.moves()) {
      continue;
    }
    std::size_t component = 0;
    for_each_component(group, step.end, [&](Index node, int i, double displacement) {
      if (const Index place = group.places[component++]; place >= 0) {
        velocities[place] = (displacement - state[node].displacement[i]) / step.length;
      }
    });
  }
  std::vector<double> impulses(velocities.size());
  mass.impose(held.components, velocities, state, impulses);
  for (const Group& group : held.groups) {
    if (group.path.moves()) {
      add_work(group, std::max(0.0, step.end - 2 * step.length), step.length, state, velocities, impulses, work);
    }
  }
}

void Constraints::add_work(const Group& group, double before, double step, std::span<const solid::NodeState> state,
                           std::span<const double> velocities, std::span<const double> impulses,
                           ReproducibleSum& work) {
  std::size_t component = 0;
  for_each_component(group, before, [&](Index node, int i, double displacement) {
    if (const Index place = group.places[component++]; place >= 0) {
      const double old = (state[node].displacement[i] - displacement) / step;
      work.add(impulses[place] * (old + velocities[place]) / 2);
    }
  });
}

std::vector<Index> Constraints::held_components() const {
  std::vector<Index> all;
  for (const Held& held : bodies_) {
    all.insert(all.end(), held.components.begin(), held.components.end());
  }
  return all;
}

}  // namespace idiophone::motion
