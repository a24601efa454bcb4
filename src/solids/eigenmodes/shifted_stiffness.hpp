#pragma once
// Static displacements of a body under given forces.

#include <petscksp.h>

#include <Eigen/Core>
#include <functional>
#include <span>
#include <vector>

#include "idiophone/foundation/parallel/petsc.hpp"
#include "operators.hpp"

namespace idiophone::eigenmodes {

/// Factors of K + shift M, on one rank.
class ShiftedStiffness {
 public:
  /// @param operators  must outlive this object
  /// @param shift      (rad/s)^2; above zero where the body can move rigidly
  /// @throws std::runtime_error where MUMPS fails, for instance without enough memory
  ShiftedStiffness(const Operators& operators, double shift);

  /// (rad/s)^2
  [[nodiscard]] double shift() const { return shift_; }

  /// The displacements along unit forces, each at a node by itself, m/N. Many at once are several times as fast.
  /// @param directions  [nodes]
  [[nodiscard]] std::vector<double> flexibilities(std::span<const Index> nodes,
                                                  std::span<const Vector3> directions) const;

  /// The displacements under forces. [3 x nodes, cases] m
  /// @param forces  [3 x nodes, cases] N; many cases at once are several times as fast
  [[nodiscard]] Eigen::MatrixXd displacements(const Eigen::MatrixXd& forces) const;

 private:
  /// Solves for several right-hand sides at once.
  /// @param take  gets each with its solution
  void solve(PetscInt columns, const std::function<parallel::Handle<Vec>(PetscInt column)>& right,
             const std::function<void(PetscInt column, Vec right, Vec solution)>& take) const;

  const Operators& operators_;
  double shift_;
  parallel::Handle<Mat> matrix_;
  parallel::Handle<KSP> solver_;
  Mat factored_ = nullptr;  // the solver's
};

}  // namespace idiophone::eigenmodes
