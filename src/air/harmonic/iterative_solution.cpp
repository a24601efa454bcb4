#include "iterative_solution.hpp"

#include <fmt/format.h>
#include <petscksp.h>

#include <stdexcept>

#include "compressed_system.hpp"
#include "idiophone/foundation/parallel/petsc.hpp"

namespace idiophone::harmonic {

namespace {

using parallel::Handle;
using parallel::petsc;

// PETSc's numbers are real: a vector holds real and imaginary parts in turn, as std::complex does.
Complex* complex_values(PetscScalar* values) {
  return reinterpret_cast<Complex*>(values);  // NOLINT(*-reinterpret-cast)
}

/// Calls action(input, output) on the complex numbers of two vectors.
template <class Action>
PetscErrorCode act(Vec input, Vec output, const Action& action) {
  PetscInt size = 0;
  const PetscScalar* from = nullptr;
  PetscScalar* to = nullptr;
  PetscCall(VecGetSize(input, &size));
  PetscCall(VecGetArrayRead(input, &from));
  PetscCall(VecGetArrayWrite(output, &to));
  const auto* read = reinterpret_cast<const Complex*>(from);  // NOLINT(*-reinterpret-cast)
  action(Eigen::Map<const Eigen::VectorXcd>(read, size / 2),
         Eigen::Map<Eigen::VectorXcd>(complex_values(to), size / 2));
  PetscCall(VecRestoreArrayWrite(output, &to));
  PetscCall(VecRestoreArrayRead(input, &from));
  return 0;
}

PetscErrorCode multiply(Mat matrix, Vec input, Vec output) {
  CompressedSystem* system = nullptr;
  PetscCall(MatShellGetContext(matrix, static_cast<void*>(&system)));
  return act(input, output, [&](const auto& from, auto to) { system->multiply(from, to); });
}

PetscErrorCode precondition(PC preconditioner, Vec input, Vec output) {
  CompressedSystem* system = nullptr;
  PetscCall(PCShellGetContext(preconditioner, static_cast<void*>(&system)));
  return act(input, output, [&](const auto& from, auto to) { system->precondition(from, to); });
}

class Gmres {
 public:
  Gmres(CompressedSystem& system, PetscInt unknowns) : size_(2 * unknowns) {
    petsc(MatCreateShell(PETSC_COMM_SELF, size_, size_, size_, size_, &system, matrix_.out()));
    petsc(MatShellSetOperation(matrix_, MATOP_MULT,
                               reinterpret_cast<void (*)()>(multiply)));  // NOLINT(*-reinterpret-cast)
    petsc(KSPCreate(PETSC_COMM_SELF, solver_.out()));
    petsc(KSPSetOperators(solver_, matrix_, matrix_));
    petsc(KSPSetType(solver_, KSPGMRES));
    petsc(KSPGMRESSetRestart(solver_, 150));
    petsc(KSPSetTolerances(solver_, 1e-5, PETSC_DEFAULT, PETSC_DEFAULT, 600));
    petsc(KSPSetPCSide(solver_, PC_RIGHT));  // so that the residual is that of the equations
    PC preconditioner = nullptr;
    petsc(KSPGetPC(solver_, &preconditioner));
    petsc(PCSetType(preconditioner, PCSHELL));
    petsc(PCShellSetContext(preconditioner, &system));
    petsc(PCShellSetApply(preconditioner, precondition));
    petsc(KSPSetOptionsPrefix(solver_, "radiation_"));
    petsc(KSPSetFromOptions(solver_));
  }

  /// @throws std::runtime_error if it does not converge
  [[nodiscard]] Eigen::VectorXcd solve(Eigen::VectorXcd right_side, double wave_number) {
    Eigen::VectorXcd solution = Eigen::VectorXcd::Zero(right_side.size());
    Handle<Vec> given, found;
    for (const auto& [values, vector] : {std::pair(&right_side, &given), std::pair(&solution, &found)}) {
      auto* parts = reinterpret_cast<PetscScalar*>(values->data());  // NOLINT(*-reinterpret-cast)
      petsc(VecCreateSeqWithArray(PETSC_COMM_SELF, 1, size_, parts, vector->out()));
    }
    petsc(KSPSolve(solver_, given, found));
    KSPConvergedReason reason{};
    PetscInt iterations = 0;
    PetscReal residual = 0.0;
    petsc(KSPGetConvergedReason(solver_, &reason));
    petsc(KSPGetIterationNumber(solver_, &iterations));
    petsc(KSPGetResidualNorm(solver_, &residual));
    if (reason < 0) {
      throw std::runtime_error(fmt::format(
          "boundary elements: GMRES did not converge at the wave number {:.4g}/m: after {} iterations the residual is "
          "{:.2g} of the right side. Is the surface closed and without overlaps? Triangles of even size help, and "
          "-radiation_ksp_max_it and -radiation_ksp_rtol change the limits",
          wave_number, iterations, residual / right_side.norm()));
    }
    return solution;
  }

 private:
  PetscInt size_;
  Handle<Mat> matrix_;
  Handle<KSP> solver_;
};

}  // namespace

Eigen::MatrixXcd solve_iteratively(const Equations& equations, std::span<const PointSource> sources,
                                   double longest_edge) {
  CompressedSystem system(equations, sources, longest_edge);
  Gmres gmres(system, static_cast<PetscInt>(equations.vertices()));
  Eigen::MatrixXcd pressure(equations.vertices(), equations.slopes.cols());
  for (Eigen::Index m = 0; m < pressure.cols(); ++m) {
    pressure.col(m) = gmres.solve(system.right_sides().col(m), equations.wave_number);
  }
  return pressure;
}

}  // namespace idiophone::harmonic
