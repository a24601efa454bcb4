#pragma once
// Stiffness and mass of joined bodies among the components that are free to move, and what else their modes need of
// them.

#include <petscmat.h>

#include <functional>
#include <span>
#include <vector>

#include "eigen_problem.hpp"
#include "idiophone/foundation/parallel/petsc.hpp"
#include "idiophone/solids/eigenmodes/eigenmodes.hpp"
#include "idiophone/solids/motion/assembly.hpp"
#include "idiophone/solids/motion/dynamics.hpp"

namespace idiophone::eigenmodes {

class Operators : public EigenProblem {
 public:
  /// Collective. See find_modes.
  Operators(const scene::Solids& solids, const mesh::Part& part, const motion::Attachments& attachments,
            MassMatrix mass, MPI_Comm communicator);
  /// About a rest that is known, under forces of other bodies.
  /// @param rest  displacements, m, [3 x owned nodes]
  Operators(const scene::Solids& solids, const mesh::Part& part, const motion::Attachments& attachments,
            MassMatrix mass, std::span<const double> rest, MPI_Comm communicator);

  [[nodiscard]] Mat stiffness() const override { return stiffness_; }  ///< supports and joints included
  [[nodiscard]] Mat mass() const override { return mass_; }
  [[nodiscard]] PetscInt size() const { return size_; }  ///< free components on all ranks
  [[nodiscard]] const motion::FiniteElementDynamics& dynamics() const { return dynamics_; }
  [[nodiscard]] bool is_deformed() const { return is_deformed_; }  ///< the rest is not that of undeformed bodies
  /// Where the bodies rest: displacements of the local nodes, ghosts included.
  [[nodiscard]] std::span<const solid::NodeState> rest() const { return rest_; }
  [[nodiscard]] const std::vector<double>& support() const { return support_; }  ///< at owned nodes, N/m
  [[nodiscard]] const std::vector<double>& dashpot() const { return dashpot_; }  ///< at owned nodes, N s/m

  /// Whether an owned component, 3 node + axis, is free.
  [[nodiscard]] bool is_free(std::size_t component) const { return components_.number[component] >= 0; }
  /// The row of an owned component in the matrices; -1 where it is held.
  [[nodiscard]] PetscInt number(std::size_t component) const { return components_.number[component]; }

  /// A new vector of the free components out of values at the owned nodes.
  /// @param field  [3 x owned nodes]
  [[nodiscard]] parallel::Handle<Vec> restricted(const std::vector<double>& field) const override;
  /// Values at the owned nodes, zero where held, out of a vector of the free components. [3 x owned nodes]
  [[nodiscard]] std::vector<double> extended(Vec vector) const override;

 private:
  /// Of undeformed bodies, without matrices.
  Operators(const scene::Solids& solids, const mesh::Part& part, const motion::Attachments& attachments,
            MPI_Comm communicator);
  void assemble(const mesh::Part& part, MassMatrix mass, MPI_Comm communicator);
  /// Adds the matrices of the elements of one body.
  void add_elements(
      const mesh::Part& part, std::size_t number, Mat matrix,
      const std::function<Eigen::MatrixXd(std::size_t region, std::span<const Vector3> positions)>& of_element);
  void add_lumped_mass(std::size_t bodies, MPI_Comm communicator);
  void add_diagonal(Mat matrix, const std::vector<double>& values) const;

  motion::FiniteElementDynamics dynamics_;
  motion::Components components_;
  std::vector<double> support_;
  std::vector<double> dashpot_;
  PetscInt size_ = 0;
  bool is_deformed_ = false;
  std::vector<solid::NodeState> rest_;
  parallel::Handle<Mat> stiffness_;
  parallel::Handle<Mat> mass_;
};

}  // namespace idiophone::eigenmodes
