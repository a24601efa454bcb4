#pragma once
// The part of a body that a spring or a hinge holds. It moves as the mean motion and mean strain of its elements say:
// a point that goes with it is a weighted sum of their nodes. Such weights spread a force over the nodes without adding
// a moment. Theory: docs/method/joints.md.

#include <Eigen/Core>
#include <vector>

#include "idiophone/solids/joints/held_parts.hpp"

namespace idiophone::joints {

class Anchor {
 public:
  /// @param held        at least one face, and the elements behind it
  /// @param first_node  global number of the first node of the mesh
  Anchor(const mesh::Mesh& mesh, const HeldPart& held, Index first_node);

  /// Ascending global numbers.
  [[nodiscard]] const std::vector<Index>& nodes() const { return nodes_; }

  /// Each node's share of the force of a constant stress on the faces; the shares add up to 1. [nodes]
  [[nodiscard]] const std::vector<double>& shares() const { return shares_; }

  /// Weights that add up to 1 and whose sum of places is the point, in the undeformed body. [nodes]
  /// @param point  m
  [[nodiscard]] std::vector<double> weights_at(const Vector3& point) const;

  /// Weights that add up to 0 and whose sum of places is the direction, in the undeformed body. [nodes] 1/m times m
  [[nodiscard]] std::vector<double> slopes_along(const Vector3& direction) const;

  [[nodiscard]] const Vector3& middle() const { return middle_; }  ///< of the faces, m
  /// Outward unit normal of the faces, on average: shorter where they face several ways, zero where they are closed.
  [[nodiscard]] const Vector3& normal() const { return normal_; }
  [[nodiscard]] const Vector3& centre() const { return centre_; }  ///< of the elements, m
  [[nodiscard]] double radius() const { return radius_; }          ///< of a sphere around it that holds all nodes, m
  [[nodiscard]] double width() const { return width_; }            ///< cube root of the elements' volume, m

 private:
  void add_faces(const mesh::Mesh& mesh, const std::vector<mesh::ElementFace>& faces);
  /// Integrals of the square of each shape function over some elements, as parts of their sum.
  void add_elements(const mesh::Mesh& mesh, const std::vector<Index>& elements);
  /// Of a node of the mesh.
  [[nodiscard]] std::size_t place_of(Index node) const;

  std::vector<Index> nodes_;  // numbers of the mesh until all is added
  std::vector<double> shares_;
  std::vector<double> parts_;     // [nodes] each node's part of the volume, without unit
  std::vector<Vector3> arms_;     // [nodes] from the centre, m
  Eigen::Matrix3d inverse_gram_;  // of sum of parts arm arm^T, 1/m2
  Vector3 middle_ = Vector3::Zero();
  Vector3 normal_ = Vector3::Zero();
  Vector3 centre_ = Vector3::Zero();
  double radius_ = 0.0;
  double width_ = 0.0;
};

}  // namespace idiophone::joints
