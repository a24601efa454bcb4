#pragma once
// Joints on meshes: where two surfaces are joined, point by point. Theory: docs/method/joints.md.

#include <mpi.h>

#include <array>
#include <span>
#include <vector>

#include "idiophone/scene/solids.hpp"
#include "idiophone/solids/joints/held_parts.hpp"
#include "idiophone/solids/mesh/mesh.hpp"

namespace idiophone::joints {

/// How much a node takes part in a point of a surface, which is the sum of value times place. The two tangents there
/// are the sums of slope times place.
struct NodeWeight {
  Index node = 0;
  double value = 0.0;             ///< of a layer: its shape function there
  std::array<double, 2> slope{};  ///< of a layer: along the two coordinates of the face; 0 on the second surface
};

/// A point of the first surface and the point of the second one on its normal, undeformed: of a layer, a quadrature
/// point; of a spring, the middles of the surfaces, and the normal is its line; of a hinge, an end of the axis as both
/// bodies have it; of a shank, its middle as both ends carry it along, and the normal is its line.
struct JointPoint {
  double area = 0.0;       ///< that it stands for, m2; 1 of a spring, hinge or shank
  double distance = 0.0;   ///< of the second point, along the outward normal of the first surface, m
  Index first_begin = 0;   ///< weights of the first surface are MeshedJoint::weights[first_begin, second_begin)
  Index second_begin = 0;  ///< those of the second one are [second_begin, end)
  Index end = 0;
};

/// A joint in global node numbers, or in those of a part.
struct MeshedJoint {
  std::size_t joint = 0;  ///< index into Solids::joints; a hinge that resists turning has two of it, a bolt
                          ///< with a shank four
  bool resists_turning =
      false;                ///< this one does so: its weights have no values, and slopes of both bodies along a
                            ///< direction each, at right angles to the axis and to each other; normal is in N m/rad
  double normal = 0.0;      ///< stiffness, Pa/m; N/m of a spring, hinge or shank
  double tangential = 0.0;  ///< stiffness, Pa/m; N/m of a spring, hinge or shank
  double damping = 0.0;     ///< relaxation time, s
  double reach = 0.0;       ///< of a layer: up to this distance the surfaces are joined, m
  std::vector<JointPoint> points;
  std::vector<NodeWeight> weights;  ///< of all points

  [[nodiscard]] double area() const;              ///< that a layer joins, m2
  [[nodiscard]] double largest_distance() const;  ///< between the two surfaces, m
  /// Of both surfaces.
  [[nodiscard]] std::span<const NodeWeight> weights_of(const JointPoint& point) const {
    return std::span(weights).subspan(point.first_begin, point.end - point.first_begin);
  }
};

/// The joints of the scene, in global node numbers. Call where the meshes are.
/// @throws deck::DeckError, pointing at the group, when the mesh lacks it, it has no faces on the surface, or a spring
/// or
///         hinge would hold too many nodes of it or lies too far from it; pointing at the joint, when no part of the
///         two surfaces is within its reach
[[nodiscard]] std::vector<MeshedJoint> find_joints(const scene::Solids& solids, const std::vector<mesh::Mesh>& meshes);
/// The same where springs, hinges and shanks hold parts that are known, such as refined ones.
[[nodiscard]] std::vector<MeshedJoint> find_joints(const scene::Solids& solids, const std::vector<mesh::Mesh>& meshes,
                                                   const HeldParts& held);

/// Rank 0's joints, on every rank. Collective.
[[nodiscard]] std::vector<MeshedJoint> broadcast(std::vector<MeshedJoint> joints, MPI_Comm communicator);

/// Sets of nodes that a joint couples, for mesh::distribute().
[[nodiscard]] std::vector<std::vector<Index>> coupled_nodes(std::span<const MeshedJoint> joints);

}  // namespace idiophone::joints
