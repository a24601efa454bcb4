#pragma once
// The balance of forces on bodies at rest: elastic forces, joints, supports, gravity and plucks.

#include <petscmat.h>

#include <span>
#include <vector>

#include "idiophone/foundation/parallel/petsc.hpp"
#include "idiophone/solids/motion/assembly.hpp"
#include "idiophone/solids/motion/dynamics.hpp"

namespace idiophone::motion {

/// Unknowns are the displacements of the bodies' nodes, [3 x nodes of the bodies] m.
class ForceBalance {
 public:
  /// @param part       the whole mesh as one part; it and the dynamics must outlive this object
  /// @param bodies     ascending; no joint ties one of them to a body that is not among them
  /// @param is_loaded  whether plucks and gravity act on the bodies
  ForceBalance(const scene::Solids& solids, const mesh::Part& part, const Attachments& attachments,
               const FiniteElementDynamics& dynamics, std::vector<std::size_t> bodies, bool is_loaded);

  [[nodiscard]] std::size_t size() const { return load_.size(); }
  [[nodiscard]] bool is_held() const;                           ///< by groups or supports
  [[nodiscard]] double load_norm() const;                       ///< Euclidean norm of all nodes' loads, N
  void set_fraction(double fraction) { fraction_ = fraction; }  ///< of the loads, and of the ways of the constraints

  /// Unbalanced force, N; for a held component, how far it is from its place, times a stiffness.
  void residual(std::span<const double> u, std::span<double> unbalanced);

  /// Tangent stiffness at displacements u.
  /// @param matrix  by create_tangent()
  void jacobian(std::span<const double> u, Mat matrix);

  /// Where each unknown is among all nodes: 3 node + axis.
  [[nodiscard]] const std::vector<Index>& places_of_unknowns() const { return place_of_unknown_; }

  /// An empty tangent stiffness.
  [[nodiscard]] parallel::Handle<Mat> create_tangent() const;

 private:
  void number_components();
  void add_gravity(const Vector3& gravity);
  void add_pluck(const mesh::Patch& patch, const Vector3& force);
  void set_displacements(std::span<const double> u);
  /// About the size of the stiffness matrix's diagonal, N/m.
  [[nodiscard]] double stiffness_scale() const;

  const mesh::Part& part_;
  const FiniteElementDynamics& dynamics_;
  std::vector<std::size_t> bodies_;
  const scene::Material& material_;  ///< of the first body
  Components components_;
  std::vector<Index> place_of_unknown_;  ///< places_of_unknowns()
  std::vector<double> support_;          ///< N/m, [nodes]
  std::vector<double> load_;             ///< N, [unknowns]
  double fraction_ = 1.0;
  std::vector<NodeState> places_;  ///< of the constraints, [nodes]
  std::vector<NodeState> state_;   ///< [nodes]
  std::vector<NodeForce> force_;
  std::vector<Index> held_;  ///< unknowns that are held
};

}  // namespace idiophone::motion
