#pragma once
// One deformable body on this rank, whatever its element type.

#include <span>
#include <variant>

#include "idiophone/mesh/part.hpp"
#include "idiophone/scene/scene.hpp"
#include "idiophone/solid/packed_elements.hpp"

namespace idiophone::solid {

class Solid {
 public:
  /// @param reference  [local nodes] positions X, m
  /// @throws std::runtime_error naming an element whose Jacobian is not positive
  Solid(const mesh::BodyPart& part, std::span<const Vector3> reference, const scene::Material& material);

  /// Adds elastic and stiffness-proportional damping forces, N. state, force: [local nodes]
  void add_internal_force(const NodeState* state, NodeForce* force) const;

  /// Adds the lumped mass. [local nodes], kg; complete only at owned nodes
  void add_mass(std::span<double> mass) const;

  /// Elastic energy of each element computed here, J, [elements]
  void elastic_energy(const NodeState* state, std::span<double> energy) const;

  /// Force of the body at rest under the linear stiffness K: adds -K x to `force`, x given as the velocities in `state`
  /// (whose displacements must be zero). At rest Kelvin-Voigt's damping force is -beta K v, and beta is set to 1 s.
  void add_linear_stiffness_force(const NodeState* state, NodeForce* force) const;

  [[nodiscard]] Index element_count() const;

 private:
  std::variant<PackedElements<Tet4>, PackedElements<Tet10>> elements_;
  ElasticLaw law_;
  double density_;
};

}  // namespace idiophone::solid
