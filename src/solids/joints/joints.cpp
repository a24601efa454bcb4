#include "idiophone/solids/joints/joints.hpp"

#include <algorithm>

#include "idiophone/foundation/each_once.hpp"
#include "idiophone/solids/mesh/local_numbers.hpp"
#include "joint_stretch.hpp"
#include "turning.hpp"

namespace idiophone::joints {

using solid::NodeForce;
using solid::NodeState;

namespace {

/// The points that have an owned node.
MeshedJoint local_joint(const MeshedJoint& joint, const mesh::Part& part) {
  const mesh::LocalNumbers numbers(part);
  MeshedJoint local{.joint = joint.joint,
                    .resists_turning = joint.resists_turning,
                    .normal = joint.normal,
                    .tangential = joint.tangential,
                    .damping = joint.damping,
                    .reach = joint.reach,
                    .points = {},
                    .weights = {}};
  for (const JointPoint& point : joint.points) {
    const auto weights = joint.weights_of(point);
    if (std::ranges::none_of(weights, [&](const NodeWeight& weight) { return numbers.owns(weight.node); })) {
      continue;
    }
    const auto begin = static_cast<Index>(local.weights.size());
    for (NodeWeight weight : weights) {
      weight.node = numbers.of(weight.node);
      local.weights.push_back(weight);
    }
    const Index shift = begin - point.first_begin;
    local.points.push_back({.area = point.area,
                            .distance = point.distance,
                            .first_begin = begin,
                            .second_begin = point.second_begin + shift,
                            .end = point.end + shift});
  }
  return local;
}

/// Calls visit() with what happens at a point: Stretch or Turning.
template <class Visitor>
void visit_point(const MeshedJoint& joint, const JointPoint& point, std::span<const Vector3> reference,
                 std::span<const NodeState> state, const Visitor& visit) {
  if (joint.resists_turning) {
    visit(Turning(joint, point, reference, state));
  } else {
    visit(Stretch(joint, point, reference, state));
  }
}

}  // namespace

Joints::Joints(std::span<const MeshedJoint> joints, const mesh::Part& part) : part_(part) {
  for (const MeshedJoint& joint : joints) {
    joints_.push_back(local_joint(joint, part));
  }
}

void Joints::add_force(std::span<const NodeState> state, std::span<NodeForce> force) const {
  for (const MeshedJoint& joint : joints_) {
    for (const JointPoint& point : joint.points) {
      visit_point(joint, point, part_.reference, state, [&](const auto& what) {
        what.for_each_force([&](Index node, const Vector3& at_node) {
          for (int i = 0; i < 3; ++i) {
            force[node].component[i] += at_node[i];
          }
        });
      });
    }
  }
}

void Joints::add_energy(std::span<const NodeState> state, ReproducibleSum& energy) const {
  for (const MeshedJoint& joint : joints_) {
    for (const JointPoint& point : joint.points) {
      if (joint.weights[point.first_begin].node < part_.owned_nodes) {
        visit_point(joint, point, part_.reference, state, [&](const auto& what) { energy.add(what.energy()); });
      }
    }
  }
}

void Joints::for_each_stiffness(std::size_t joint, const Visitor& visit) const {
  for_each_stiffness(joint, std::vector<NodeState>(part_.reference.size()), visit);
}

void Joints::for_each_stiffness(std::size_t joint, std::span<const NodeState> state, const Visitor& visit) const {
  std::vector<Index> nodes;
  const MeshedJoint& meshed = joints_[joint];
  for (const JointPoint& point : meshed.points) {
    nodes.clear();
    std::ranges::transform(meshed.weights_of(point), std::back_inserter(nodes), &NodeWeight::node);
    visit_point(meshed, point, part_.reference, state, [&](const auto& what) { visit(nodes, what.stiffness()); });
  }
}

void Joints::add_bounds(std::span<double> stiffness, std::span<double> damping) const {
  for (std::size_t joint = 0; joint < joints_.size(); ++joint) {
    for_each_stiffness(joint, [&](std::span<const Index> nodes, const Eigen::MatrixXd& matrix) {
      // No eigenvalue of diag(rows) - matrix is below zero (Gershgorin).
      const Eigen::VectorXd rows = matrix.cwiseAbs().rowwise().sum();
      for (std::size_t a = 0; a < nodes.size(); ++a) {
        const double bound = rows.segment<3>(3 * static_cast<Eigen::Index>(a)).maxCoeff();
        stiffness[nodes[a]] += bound;
        damping[nodes[a]] += joints_[joint].damping * bound;
      }
    });
  }
}

std::vector<Index> Joints::nodes() const {
  std::vector<Index> all;
  for (const MeshedJoint& joint : joints_) {
    for (const NodeWeight& weight : joint.weights) {
      if (weight.node < part_.owned_nodes) {
        all.push_back(weight.node);
      }
    }
  }
  keep_each_once(all);
  return all;
}

}  // namespace idiophone::joints
