#include "idiophone/solids/joints/meshed_joint.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "idiophone/foundation/each_once.hpp"
#include "idiophone/foundation/parallel/broadcast.hpp"

namespace idiophone::joints {

double MeshedJoint::area() const {
  return std::transform_reduce(points.begin(), points.end(), 0.0, std::plus<>(),
                               [](const JointPoint& point) { return point.area; });
}

double MeshedJoint::largest_distance() const {
  return std::transform_reduce(
      points.begin(), points.end(), 0.0, [](double a, double b) { return std::max(a, b); },
      [](const JointPoint& point) { return std::abs(point.distance); });
}

std::vector<MeshedJoint> broadcast(std::vector<MeshedJoint> joints, MPI_Comm communicator) {
  joints.resize(parallel::from_root(joints.size(), communicator));
  for (MeshedJoint& joint : joints) {
    parallel::broadcast(joint.joint, communicator);
    parallel::broadcast(joint.resists_turning, communicator);
    for (double* number : {&joint.normal, &joint.tangential, &joint.damping, &joint.reach}) {
      parallel::broadcast(*number, communicator);
    }
    parallel::broadcast(joint.points, communicator);
    parallel::broadcast(joint.weights, communicator);
  }
  return joints;
}

std::vector<std::vector<Index>> coupled_nodes(std::span<const MeshedJoint> joints) {
  std::vector<std::vector<Index>> coupled;
  for (const MeshedJoint& joint : joints) {
    for (const JointPoint& point : joint.points) {
      auto& nodes = coupled.emplace_back();
      std::ranges::transform(joint.weights_of(point), std::back_inserter(nodes), &NodeWeight::node);
      keep_each_once(nodes);
    }
  }
  keep_each_once(coupled);
  return coupled;
}

}  // namespace idiophone::joints
