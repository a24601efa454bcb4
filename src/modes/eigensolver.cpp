#include "eigensolver.hpp"

#include <fmt/format.h>
#include <slepceps.h>

#include <numbers>
#include <stdexcept>

#include "idiophone/parallel/petsc.hpp"

namespace idiophone::modes {

using parallel::petsc;

namespace {

/// A set-up EPS.
class Solver {
 public:
  Solver(const Operators& operators, int count, double shift) : operators_(operators) {
    petsc(EPSCreate(PetscObjectComm(reinterpret_cast<PetscObject>(operators.stiffness())), eps_.out()));
    petsc(EPSSetOptionsPrefix(eps_, "modes_"));
    petsc(EPSSetOperators(eps_, operators.stiffness(), operators.mass()));
    petsc(EPSSetProblemType(eps_, EPS_GHEP));
    petsc(EPSSetDimensions(eps_, count, PETSC_DEFAULT, PETSC_DEFAULT));
    petsc(EPSSetWhichEigenpairs(eps_, EPS_TARGET_MAGNITUDE));
    petsc(EPSSetTarget(eps_, -shift));
    petsc(EPSSetTolerances(eps_, 1e-10, 1000));
    ST transformation = nullptr;
    KSP linear = nullptr;
    PC factors = nullptr;
    petsc(EPSGetST(eps_, &transformation));
    petsc(STSetType(transformation, STSINVERT));
    petsc(STSetMatStructure(transformation, SUBSET_NONZERO_PATTERN));
    petsc(STGetKSP(transformation, &linear));
    petsc(KSPSetType(linear, KSPPREONLY));
    petsc(KSPGetPC(linear, &factors));
    petsc(PCSetType(factors, PCCHOLESKY));
    petsc(PCFactorSetMatSolverType(factors, MATSOLVERMUMPS));
    petsc(EPSSetFromOptions(eps_));
  }

  /// Known eigenvectors, which are not to be found again.
  void leave_out(const std::vector<std::vector<double>>& rigid_motions) {
    for (const auto& motion : rigid_motions) {
      rigid_.push_back(operators_.restricted(motion));
    }
    std::vector<Vec> vectors(rigid_.begin(), rigid_.end());
    petsc(EPSSetDeflationSpace(eps_, static_cast<PetscInt>(vectors.size()), vectors.data()));
  }

  [[nodiscard]] std::vector<Eigenpair> solve(int count) const {
    petsc(EPSSolve(eps_));
    PetscInt converged = 0;
    petsc(EPSGetConverged(eps_, &converged));
    if (converged < count) {
      throw std::runtime_error(
          fmt::format("only {} of {} modes were found; ask for fewer, or give the solver more room, for instance "
                      "-modes_eps_ncv {}",
                      converged, count, 4 * count + 40));
    }
    parallel::Handle<Vec> vector;
    petsc(MatCreateVecs(operators_.stiffness(), vector.out(), nullptr));
    std::vector<Eigenpair> pairs;
    for (PetscInt i = 0; i < count; ++i) {
      PetscScalar value = 0.0;
      PetscReal error = 0.0;
      petsc(EPSGetEigenpair(eps_, i, &value, nullptr, vector, nullptr));
      petsc(EPSComputeError(eps_, i, EPS_ERROR_RELATIVE, &error));
      if (!(value > 0) || !(error < 1e-4)) {
        throw std::runtime_error(fmt::format(
            "mode {} is wrong (eigenvalue {:.3g} 1/s2, relative residual {:.2g}): does a part of the body hang on "
            "by a line or a point?",
            i + 1, value, error));
      }
      pairs.push_back({value, operators_.extended(vector)});
    }
    return pairs;
  }

  /// The largest x^T K x/x^T M x of the vectors left out, (rad/s)^2: how far they are from being without strain.
  [[nodiscard]] double largest_rigid_quotient() const {
    parallel::Handle<Vec> image;
    petsc(MatCreateVecs(operators_.stiffness(), nullptr, image.out()));
    double largest = 0.0;
    for (const auto& vector : rigid_) {
      PetscScalar stiffness = 0.0;
      PetscScalar mass = 0.0;
      petsc(MatMult(operators_.stiffness(), vector, image));
      petsc(VecDot(vector, image, &stiffness));
      petsc(MatMult(operators_.mass(), vector, image));
      petsc(VecDot(vector, image, &mass));
      largest = std::max(largest, std::abs(stiffness) / mass);
    }
    return largest;
  }

 private:
  const Operators& operators_;
  std::vector<parallel::Handle<Vec>> rigid_;
  parallel::Handle<EPS> eps_;
};

}  // namespace

int count_below(const Operators& operators, double value) {
  parallel::Handle<Mat> shifted;
  parallel::Handle<PC> factors;
  petsc(MatDuplicate(operators.stiffness(), MAT_COPY_VALUES, shifted.out()));
  petsc(MatAXPY(shifted, -value, operators.mass(), SUBSET_NONZERO_PATTERN));
  petsc(MatSetOption(shifted, MAT_SYMMETRIC, PETSC_TRUE));
  petsc(PCCreate(PetscObjectComm(reinterpret_cast<PetscObject>(operators.stiffness())), factors.out()));
  petsc(PCSetOperators(factors, shifted, shifted));
  petsc(PCSetType(factors, PCCHOLESKY));
  petsc(PCFactorSetMatSolverType(factors, MATSOLVERMUMPS));
  petsc(PCFactorSetUpMatSolverType(factors));
  Mat factored = nullptr;
  petsc(PCFactorGetMatrix(factors, &factored));
  petsc(MatMumpsSetIcntl(factored, 13, 1));  // the root of the tree on one rank, or its pivots are not counted
  petsc(PCSetUp(factors));
  PetscInt negative = 0;
  petsc(MatGetInertia(factored, &negative, nullptr, nullptr));
  return static_cast<int>(negative);
}

std::vector<Eigenpair> lowest_eigenpairs(const Operators& operators,
                                         const std::vector<std::vector<double>>& rigid_motions, int count,
                                         double shift) {
  Solver solver(operators, count, shift);
  solver.leave_out(rigid_motions);
  std::vector<Eigenpair> pairs = solver.solve(count);
  std::ranges::sort(pairs, {}, &Eigenpair::value);
  const double quotient = solver.largest_rigid_quotient();
  constexpr double negligible = 1e-3;
  if (quotient > negligible * pairs.front().value) {
    throw std::runtime_error(fmt::format(
        "the body's rigid motions can't be told from its modes: they strain it as if at {:.3g} Hz, and the lowest mode "
        "is at {:.3g} Hz",
        std::sqrt(quotient) / (2 * std::numbers::pi), std::sqrt(pairs.front().value) / (2 * std::numbers::pi)));
  }
  return pairs;
}

}  // namespace idiophone::modes
