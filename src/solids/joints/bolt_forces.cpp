#include "idiophone/solids/joints/bolt_forces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "idiophone/foundation/parallel/reduce.hpp"
#include "joint_stretch.hpp"

namespace idiophone::joints {

namespace {

bool has_preload(const scene::Joint& joint) {
  return joint.shank && joint.shank->preload > 0;
}

/// Distance from the axis of a bolt, m, if the bolt presses together what is there: between its ends, within cones of
/// 45 degrees that begin at the rims of its washers.
std::optional<double> distance_if_pressed(const Vector3& place, const scene::Joint& bolt) {
  const Vector3 line = bolt.axis.end - bolt.axis.begin, from_begin = place - bolt.axis.begin;
  const double length = line.norm(), along = line.dot(from_begin) / length;
  const double distance = (from_begin - along / length * line).norm();
  const bool is_pressed =
      along > 0 && along < length && distance <= bolt.shank->washer + std::min(along, length - along);
  return is_pressed ? std::optional(distance) : std::nullopt;
}

/// The bolt that presses a place together; of several ones, the nearest.
std::optional<std::size_t> bolt_around(const Vector3& place, std::span<const scene::Joint> joints) {
  std::optional<std::size_t> nearest;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t bolt = 0; bolt < joints.size(); ++bolt) {
    const auto distance = has_preload(joints[bolt]) ? distance_if_pressed(place, joints[bolt]) : std::nullopt;
    if (distance && *distance < least) {
      least = *distance;
      nearest = bolt;
    }
  }
  return nearest;
}

/// Of the first surface, m.
Vector3 place_of(const MeshedJoint& joint, const JointPoint& point, std::span<const Vector3> reference) {
  Vector3 place = Vector3::Zero();
  for (Index w = point.first_begin; w < point.second_begin; ++w) {
    place += joint.weights[w].value * reference[joint.weights[w].node];
  }
  return place;
}

/// The bolt that a point of a joint belongs to: the point of its shank, or one of a layer that it presses together.
std::optional<std::size_t> bolt_of(const MeshedJoint& meshed, const JointPoint& point, const scene::Solids& solids,
                                   std::span<const Vector3> reference) {
  const scene::Joint& joint = solids.joints[meshed.joint];
  if (joint.is_layer()) {
    return bolt_around(place_of(meshed, point, reference), solids.joints);
  }
  return has_preload(joint) && !meshed.resists_turning ? std::optional(meshed.joint) : std::nullopt;
}

/// What the pull at a point takes off the preload of a bolt, 1/N: a shank loses what the pull falls by, and a layer has
/// a part of its pull along the axis.
double factor_of(const scene::Joint& bolt, bool is_of_shank, const Vector3& normal) {
  const Vector3 axis = (bolt.axis.end - bolt.axis.begin).normalized();
  return (is_of_shank ? -1.0 : std::abs(axis.dot(normal))) / bolt.shank->preload;
}

/// On this rank.
std::vector<BoltForcePoint> points_of_bolts(const scene::Solids& solids, const Joints& joints, const mesh::Part& part) {
  std::vector<BoltForcePoint> points;
  for (std::size_t j = 0; j < joints.all().size(); ++j) {
    const MeshedJoint& meshed = joints.all()[j];
    for (std::size_t p = 0; p < meshed.points.size(); ++p) {
      const JointPoint& point = meshed.points[p];
      if (meshed.weights[point.first_begin].node >= part.owned_nodes) {
        continue;
      }
      if (const auto bolt = bolt_of(meshed, point, solids, part.reference)) {
        const BoltForce force{*bolt, meshed.joint};
        const Vector3 normal = undeformed_frame(meshed, point, part.reference).normal;
        points.push_back({force, j, p, factor_of(solids.joints[*bolt], force.is_of_shank(), normal)});
      }
    }
  }
  return points;
}

std::vector<std::size_t> bolts_with_preload(std::span<const scene::Joint> joints) {
  std::vector<std::size_t> bolts;
  for (std::size_t joint = 0; joint < joints.size(); ++joint) {
    if (has_preload(joints[joint])) {
      bolts.push_back(joint);
    }
  }
  return bolts;
}

/// Those that have a point on any rank. Collective.
std::vector<BoltForce> forces_with_points(const std::vector<BoltForcePoint>& points,
                                          std::span<const scene::Joint> joints, MPI_Comm communicator) {
  const std::vector<std::size_t> bolts = bolts_with_preload(joints);
  if (bolts.empty()) {
    return {};
  }
  std::vector<int> has_points(bolts.size() * joints.size());
  for (const BoltForcePoint& point : points) {
    const auto row = static_cast<std::size_t>(std::ranges::find(bolts, point.force.bolt) - bolts.begin());
    has_points[row * joints.size() + point.force.joint] = 1;
  }
  parallel::reduce(has_points, MPI_MAX, communicator);
  std::vector<BoltForce> forces;
  for (std::size_t place = 0; place < has_points.size(); ++place) {
    if (has_points[place] != 0) {
      forces.push_back({bolts[place / joints.size()], place % joints.size()});
    }
  }
  return forces;
}

}  // namespace

BoltForces::BoltForces(const scene::Solids& solids, const Joints& joints, const mesh::Part& part, MPI_Comm communicator)
    : joints_(joints),
      part_(part),
      points_(points_of_bolts(solids, joints, part)),
      forces_(forces_with_points(points_, solids.joints, communicator)) {
  for (const BoltForcePoint& point : points_) {
    force_of_point_.push_back(static_cast<std::size_t>(std::ranges::find(forces_, point.force) - forces_.begin()));
  }
}

std::vector<ReproducibleSum> BoltForces::taken(std::span<const solid::NodeState> state) const {
  std::vector<ReproducibleSum> sums(forces_.size());
  for (std::size_t p = 0; p < points_.size(); ++p) {
    const MeshedJoint& joint = joints_.all()[points_[p].joint];
    const Stretch stretch(joint, joint.points[points_[p].point], part_.reference, state);
    sums[force_of_point_[p]].add(points_[p].factor * stretch.pull());
  }
  return sums;
}

}  // namespace idiophone::joints
