#include "idiophone/motion/loads.hpp"

#include <algorithm>
#include <iterator>

namespace idiophone::motion {

namespace {

/// Whether a signal is zero from `begin` to `end` (s), both included, because it has not begun or is over.
bool is_silent(const scene::Signal& signal, double begin, double end) {
  const bool has_table = signal.shape == scene::Signal::Shape::table;
  const double first = has_table ? signal.table.front()[0] : 0.0;
  const double last = has_table ? signal.table.back()[0] : signal.duration;
  return end - signal.start < first || begin - signal.start > last;
}

}  // namespace

Loads::Loads(const scene::Scene& scene, const mesh::Part& part, const Attachments& attachments) {
  for (std::size_t i = 0; i < scene.pulses.size(); ++i) {
    pulses_.push_back({owned(attachments.pulses[i], part), scene.pulses[i].force, scene.pulses[i].signal});
  }
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const auto& supports = scene.bodies[b].supports;
    for (std::size_t i = 0; i < supports.size(); ++i) {
      const mesh::Patch patch = owned(attachments.bodies[b].supports[i], part);
      for (std::size_t n = 0; n < patch.nodes.size(); ++n) {
        springs_.push_back(
            {patch.nodes[n], supports[i].stiffness * patch.shares[n], supports[i].damping * patch.shares[n]});
      }
    }
  }
}

void Loads::add(double time, std::span<const NodeState> state, std::span<NodeForce> force) const {
  for (const Pulse& pulse : pulses_) {
    const double factor = pulse.signal.at(time);
    if (factor == 0.0) {
      continue;
    }
    for (std::size_t n = 0; n < pulse.patch.nodes.size(); ++n) {
      for (int i = 0; i < 3; ++i) {
        force[pulse.patch.nodes[n]].component[i] += factor * pulse.patch.shares[n] * pulse.force[i];
      }
    }
  }
  for (const Spring& spring : springs_) {
    const NodeState& node = state[spring.node];
    for (int i = 0; i < 3; ++i) {
      force[spring.node].component[i] -= spring.stiffness * node.displacement[i] + spring.damping * node.velocity[i];
    }
  }
}

void Loads::add_work(const Step& step, std::span<const NodeState> state, ReproducibleSum& work) const {
  for (const Pulse& pulse : pulses_) {
    const double factor = pulse.signal.at(step.begin);
    if (factor == 0.0) {
      continue;
    }
    for (std::size_t n = 0; n < pulse.patch.nodes.size(); ++n) {
      const Eigen::Map<const Vector3> velocity(state[pulse.patch.nodes[n]].velocity);
      work.add(step.length * factor * pulse.patch.shares[n] * pulse.force.dot(velocity));
    }
  }
}

std::vector<Index> Loads::pulsed_nodes(double begin, double end) const {
  std::vector<Index> all;
  for (const Pulse& pulse : pulses_) {
    if (!is_silent(pulse.signal, begin, end)) {
      all.insert(all.end(), pulse.patch.nodes.begin(), pulse.patch.nodes.end());
    }
  }
  return all;
}

std::vector<Index> Loads::nodes() const {
  std::vector<Index> all;
  for (const Pulse& pulse : pulses_) {
    all.insert(all.end(), pulse.patch.nodes.begin(), pulse.patch.nodes.end());
  }
  std::ranges::transform(springs_, std::back_inserter(all), &Spring::node);
  return all;
}

void Loads::add_support_stiffness(std::span<double> stiffness) const {
  for (const Spring& spring : springs_) {
    stiffness[spring.node] += spring.stiffness;
  }
}

void Loads::add_support_damping(std::span<double> damping) const {
  for (const Spring& spring : springs_) {
    damping[spring.node] += spring.damping;
  }
}

}  // namespace idiophone::motion
