#pragma once
// The eigenvalue problem of a body in a plane, on one rank.

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "eigen_problem.hpp"
#include "eigensolver.hpp"
#include "idiophone/foundation/types.hpp"
#include "idiophone/solids/eigenmodes/plane_mode.hpp"

namespace idiophone::eigenmodes {

/// Its fields have a number for each unknown. Those that are held have no row in the matrices.
class PlaneProblem : public EigenProblem {
 public:
  /// @param held  [unknowns]
  explicit PlaneProblem(const std::vector<bool>& held);

  /// Adds an element. @param stiffness, mass  symmetric, [unknowns x unknowns]
  void add(std::span<const Index> unknowns, const Eigen::MatrixXd& stiffness, const Eigen::MatrixXd& mass);

  /// To be called after the last element.
  void assemble();

  [[nodiscard]] Mat stiffness() const override { return stiffness_; }
  [[nodiscard]] Mat mass() const override { return mass_; }
  [[nodiscard]] PetscInt size() const { return size_; }
  [[nodiscard]] parallel::Handle<Vec> restricted(const std::vector<double>& field) const override;
  [[nodiscard]] std::vector<double> extended(Vec vector) const override;

 private:
  std::vector<PetscInt> rows_;  ///< [unknowns] row of each; -1 where held
  PetscInt size_ = 0;
  parallel::Handle<Mat> stiffness_;
  parallel::Handle<Mat> mass_;
};

/// The eigenpairs of the wanted modes, ascending, without the rigid motions.
/// @param body   "membrane" or "plate", for messages
/// @param shift  as of lowest_eigenpairs()
/// @throws NoModes where there are none; std::runtime_error where there are not so many, or the solver fails
[[nodiscard]] std::vector<Eigenpair> wanted_eigenpairs(const PlaneProblem& problem, const std::string& body,
                                                       const std::vector<std::vector<double>>& rigid_motions,
                                                       const WantedModes& wanted, double shift);

/// Hz, of an eigenvalue in (rad/s)^2
[[nodiscard]] double frequency_of(double eigenvalue);

/// Turns the sign of a shape so that its largest value is positive; of values that are as large, the first counts.
void orient_shape(std::vector<double>& shape);

}  // namespace idiophone::eigenmodes
