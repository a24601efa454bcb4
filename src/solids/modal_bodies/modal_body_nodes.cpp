// The nodes of a modal body: which ones follow the modes in each step, and where they are.

#include "modal_body.hpp"

#include <bit>

#include "idiophone/foundation/cross_matrix.hpp"
#include "idiophone/foundation/each_once.hpp"

namespace idiophone::modal_bodies {

namespace {

/// Component `i` of a 3 x 3 matrix times the vectors of a pack.
Pack row_times(const Eigen::Matrix3d& matrix, Eigen::Index i, const PackVector& vectors) {
  return matrix(i, 0) * vectors[0] + matrix(i, 1) * vectors[1] + matrix(i, 2) * vectors[2];
}

PackVector times(const Eigen::Matrix3d& matrix, const PackVector& vectors) {
  return {row_times(matrix, 0, vectors), row_times(matrix, 1, vectors), row_times(matrix, 2, vectors)};
}

PackVector plus(const PackVector& a, const PackVector& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

/// Displacements of the nodes of a pack.
/// @param vibration  displacements in the frame, m
PackVector displaced(const FloatingFrame& frame, const PackVector& arms, const PackVector& vibration) {
  PackVector result = plus(times(frame.turn_less_one(), plus(arms, vibration)), vibration);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    result.at(axis) += frame.shift()[static_cast<Eigen::Index>(axis)];
  }
  return result;
}

}  // namespace

int ModalBody::resolved(int most_at_once) const {
  constexpr double most = 2.5;
  int steps = most_at_once;
  while (steps > 1 && (most_at_once % steps != 0 || steps * step_ * highest_frequency_ > most)) {
    --steps;
  }
  return steps;
}

void ModalBody::choose_nodes(std::span<const Index> nodes, int most_at_once) {
  steps_at_once_ = is_alone() ? resolved(most_at_once) : 1;  // others of common modes may need each step
  std::vector<std::size_t> chosen;
  for (const Index node : nodes) {
    if (node >= body_.owned_begin && node < body_.owned_end) {
      chosen.push_back(node - body_.owned_begin);
    }
  }
  keep_each_once(chosen);
  residual_.choose(chosen, steps_at_once_ * step_);
  if (chosen != chosen_.nodes()) {
    chosen_ = NodeGroup(shapes_, inertia_.arms(), std::move(chosen));
  }
}

void ModalBody::update_nodes(std::span<NodeState> state) {
  for (std::size_t pack = 0; pack < all_.packs(); ++pack) {
    move(all_, pack, all_.vibration(pack, coordinates().places(), coordinates().rates()), state);
  }
  update_chosen(state);
}

void ModalBody::update_chosen(std::span<NodeState> state) const {
  for (std::size_t pack = 0; pack < chosen_.packs(); ++pack) {
    NodeGroup::Vibration vibration = chosen_.vibration(pack, coordinates().places(), coordinates().rates());
    residual_.add(pack, vibration);
    move(chosen_, pack, vibration, state);
  }
}

void ModalBody::move(const NodeGroup& group, std::size_t pack, const NodeGroup::Vibration& vibration,
                     std::span<NodeState> state) const {
  const PackVector displacement = displaced(frame_, group.arms(pack), vibration.displacement);
  const PackVector carried =
      times(cross_matrix(frame_.spin()) * frame_.turn(), plus(group.arms(pack), vibration.displacement));
  const PackVector vibrating = times(frame_.turn(), vibration.velocity);
  Pack rows[solid::line_length] = {};  // the numbers of a NodeState
  for (std::size_t axis = 0; axis < 3; ++axis) {
    rows[axis] = displacement.at(axis);
    rows[3 + axis] = frame_.velocity()[static_cast<Eigen::Index>(axis)] + (carried.at(axis) + vibrating.at(axis));
  }
  std::array<NodeState, solid::lanes> states;
  solid::write_lines(rows, [&](int lane) { return states.at(static_cast<std::size_t>(lane)).displacement; });
  for (std::size_t lane = 0; lane < group.nodes(pack).size(); ++lane) {
    NodeState& of_node = state[body_.owned_begin + group.nodes(pack)[lane]];
    of_node = states.at(lane);
    if (!rest_.empty()) {
      Vector3::Map(of_node.displacement) += rest_[group.nodes(pack)[lane]];
    }
  }
}

}  // namespace idiophone::modal_bodies
