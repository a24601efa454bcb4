#include "idiophone/solids/motion/loads.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <iterator>

#include "idiophone/foundation/inertia_tensor.hpp"
#include "idiophone/solids/motion/initial_state.hpp"

namespace idiophone::motion {

namespace {

/// Whether a signal is zero from `begin` to `end` (s), both included, because it has not begun or is over.
bool is_silent(const scene::Signal& signal, double begin, double end) {
  const bool has_table = signal.shape == scene::Signal::Shape::table;
  const double first = has_table ? signal.table.front()[0] : 0.0;
  return end - signal.start < first || begin > signal.end();
}

}  // namespace

Loads::Loads(const scene::Solids& solids, const mesh::Part& part, const Attachments& attachments) {
  for (std::size_t i = 0; i < solids.pulses.size(); ++i) {
    const scene::ForcePulse& pulse = solids.pulses[i];
    pulses_.push_back({owned(attachments.pulses[i], part), pulse.force, pulse.signal, pulse.body, {}, {}});
    if (pulse.is_balanced) {
      pulses_.back().balanced_at = attachments.pulse_points[i];
    }
  }
  for (std::size_t w = 0; w < solids.winds.size(); ++w) {
    winds_.emplace_back(solids.winds[w], solids.air_density, attachments.winds[w], part);
  }
  for (std::size_t i = 0; i < solids.bows.size(); ++i) {
    bows_.emplace_back(solids.bows[i], attachments.bows[i], part);
  }
  for (std::size_t b = 0; b < solids.bodies.size(); ++b) {
    const auto& supports = solids.bodies[b].supports;
    for (std::size_t i = 0; i < supports.size(); ++i) {
      const mesh::Patch patch = owned(attachments.bodies[b].supports[i], part);
      for (std::size_t n = 0; n < patch.nodes.size(); ++n) {
        springs_.push_back(
            {patch.nodes[n], supports[i].stiffness * patch.shares[n], supports[i].damping * patch.shares[n]});
      }
    }
  }
}

void Loads::begin(double step) {
  for (BowLoad& bow : bows_) {
    bow.begin(step);
  }
}

void Loads::balance(const mesh::Part& part, const InitialState& initial_state,
                    std::span<const std::span<const double>> masses) {
  for (Pulse& pulse : pulses_) {
    if (!pulse.balanced_at) {
      continue;
    }
    const std::size_t b = pulse.body;
    const Vector3& centre = initial_state.centres[b];
    const Eigen::Matrix3d& moment = initial_state.moments[b];
    const Eigen::Matrix3d inertia = inertia_tensor(moment);
    const Vector3 acceleration = pulse.force / initial_state.masses[b];
    const Vector3 angular = inertia.inverse() * (*pulse.balanced_at - centre).cross(pulse.force);
    pulse.inertia.clear();
    for (std::size_t n = 0; n < masses[b].size(); ++n) {
      const Index node = part.bodies[b].owned_begin + static_cast<Index>(n);
      const Vector3 arm = part.reference[node] - centre;
      pulse.inertia.push_back({node, -masses[b][n] * (acceleration + angular.cross(arm))});
    }
  }
}

void Loads::remember(double time, std::span<const NodeState> state) {
  for (Wind& wind : winds_) {
    wind.remember(time, state);
  }
  for (BowLoad& bow : bows_) {
    bow.remember(time, state);
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
    for (const auto& [node, inertia] : pulse.inertia) {
      for (int i = 0; i < 3; ++i) {
        force[node].component[i] += factor * inertia[i];
      }
    }
  }
  for (const Wind& wind : winds_) {
    wind.add(time, state, force);
  }
  for (const BowLoad& bow : bows_) {
    bow.add(time, state, force);
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
    for (const auto& [node, inertia] : pulse.inertia) {
      const Eigen::Map<const Vector3> velocity(state[node].velocity);
      work.add(step.length * factor * inertia.dot(velocity));
    }
  }
  for (const Wind& wind : winds_) {
    wind.add_work(step, state, work);
  }
  for (const BowLoad& bow : bows_) {
    bow.add_work(step, state, work);
  }
}

std::vector<Index> Loads::pulsed_nodes(double begin, double end) const {
  std::vector<Index> all;
  for (const Pulse& pulse : pulses_) {
    if (!is_silent(pulse.signal, begin, end)) {
      all.insert(all.end(), pulse.patch.nodes.begin(), pulse.patch.nodes.end());
      std::ranges::transform(pulse.inertia, std::back_inserter(all), &NodeForceOfPulse::node);
    }
  }
  for (const Wind& wind : winds_) {
    all.insert(all.end(), wind.nodes().begin(), wind.nodes().end());
  }
  for (const BowLoad& bow : bows_) {
    if (bow.acts(begin, end)) {
      std::ranges::copy(bow.nodes(), std::back_inserter(all));
    }
  }
  return all;
}

std::vector<Index> Loads::nodes(double begin) const {
  std::vector<Index> all;
  for (const Pulse& pulse : pulses_) {
    if (begin <= pulse.signal.end()) {
      all.insert(all.end(), pulse.patch.nodes.begin(), pulse.patch.nodes.end());
    }
  }
  for (const Wind& wind : winds_) {
    all.insert(all.end(), wind.nodes().begin(), wind.nodes().end());
  }
  for (const BowLoad& bow : bows_) {
    std::ranges::copy(bow.nodes(), std::back_inserter(all));
  }
  std::ranges::transform(springs_, std::back_inserter(all), &Spring::node);
  return all;
}

void Loads::add_support_stiffness(std::span<double> stiffness) const {
  for (const Spring& spring : springs_) {
    stiffness[spring.node] += spring.stiffness;
  }
}

void Loads::add_bow_bounds(std::span<double> stiffness, std::span<double> damping) const {
  for (const BowLoad& bow : bows_) {
    bow.add_bounds(stiffness, damping);
  }
}

void Loads::archive(parallel::Archive& archive) {
  std::vector<Index> here;  // ranks that share a patch have the same rows
  for (std::size_t b = 0; b < bows_.size(); ++b) {
    if (bows_[b].is_here()) {
      here.push_back(static_cast<Index>(b));
    }
  }
  if (!bows_.empty()) {
    const parallel::Rows rows(here, static_cast<std::int64_t>(bows_.size()), archive.communicator());
    archive.rows("motion/bows", rows,
                 [&](std::size_t row, parallel::ArchiveRow& numbers) { bows_[here[row]].archive(numbers); });
  }
}

void Loads::add_support_damping(std::span<double> damping) const {
  for (const Spring& spring : springs_) {
    damping[spring.node] += spring.damping;
  }
}

}  // namespace idiophone::motion
