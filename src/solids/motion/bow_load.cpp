#include "idiophone/solids/motion/bow_load.hpp"

#include <algorithm>

#include "idiophone/solids/mesh/local_numbers.hpp"

namespace idiophone::motion {

BowLoad::BowLoad(const scene::Bow& bow, const mesh::Patch& patch, const mesh::Part& part) : bow_(bow) {
  const mesh::LocalNumbers numbers(part);
  if (std::ranges::none_of(patch.nodes, [&](Index node) { return numbers.owns(node); })) {
    return;
  }
  for (std::size_t n = 0; n < patch.nodes.size(); ++n) {
    nodes_.push_back({numbers.of(patch.nodes[n]), patch.shares[n], numbers.owns(patch.nodes[n])});
  }
}

void BowLoad::begin(double step) {
  friction_.emplace(bow_.friction, step, friction::Deflection::end);
}

double BowLoad::relative_velocity(double time, std::span<const NodeState> state) const {
  double velocity = 0.0;
  for (const Node& node : nodes_) {
    velocity += node.share * bow_.direction.dot(Eigen::Map<const Vector3>(state[node.number].velocity));
  }
  return bow_.speed.at(time - bow_.start) - velocity;
}

/// visit(node, force) for each owned node.
template <class Visit>
void BowLoad::visit_forces(double time, std::span<const NodeState> state, const Visit& visit) const {
  const double whole = is_here() ? friction_->force(relative_velocity(time, state), load(time)) : 0.0;
  for (const Node& node : nodes_) {
    if (whole != 0.0 && node.is_owned) {
      visit(node.number, Vector3(node.share * whole * bow_.direction));
    }
  }
}

void BowLoad::add(double time, std::span<const NodeState> state, std::span<NodeForce> force) const {
  visit_forces(time, state, [&](Index node, const Vector3& at_node) {
    for (int i = 0; i < 3; ++i) {
      force[node].component[i] += at_node[i];
    }
  });
}

std::array<ReproducibleSum, 3> BowLoad::total(double time, std::span<const NodeState> state) const {
  std::array<ReproducibleSum, 3> sums;
  visit_forces(time, state, [&](Index /*node*/, const Vector3& at_node) {
    for (int i = 0; i < 3; ++i) {
      sums[i].add(at_node[i]);
    }
  });
  return sums;
}

void BowLoad::remember(double time, std::span<const NodeState> state) {
  if (is_here()) {
    const double velocity = relative_velocity(time, state);
    noted_ = friction_->force(velocity, load(time));
    friction_->advance(velocity, load(time));
  }
}

void BowLoad::add_work(const Step& step, std::span<const NodeState> state, ReproducibleSum& work) const {
  for (const Node& node : nodes_) {
    if (node.is_owned) {
      const Eigen::Map<const Vector3> velocity(state[node.number].velocity);
      work.add(step.length * node.share * noted_ * bow_.direction.dot(velocity));
    }
  }
}

void BowLoad::add_bounds(std::span<double> stiffness, std::span<double> damping) const {
  // The shares add up to 1, so that the square of the patch's motion is at most the shares times those of its nodes.
  for (const Node& node : nodes_) {
    stiffness[node.number] += node.share * bow_.friction.stiffness;
    damping[node.number] += node.share * (bow_.friction.damping + bow_.friction.viscosity);
  }
}

bool BowLoad::acts(double begin, double end) const {
  return end > bow_.start && begin < bow_.start + bow_.duration;
}

std::vector<Index> BowLoad::nodes() const {
  std::vector<Index> owned;
  for (const Node& node : nodes_) {
    if (node.is_owned) {
      owned.push_back(node.number);
    }
  }
  return owned;
}

}  // namespace idiophone::motion
