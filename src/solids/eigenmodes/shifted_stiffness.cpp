#include "shifted_stiffness.hpp"

#include "shifted_matrix.hpp"

namespace idiophone::eigenmodes {

using parallel::petsc;

ShiftedStiffness::ShiftedStiffness(const Operators& operators, double shift)
    : operators_(operators), shift_(shift), matrix_(shifted_matrix(operators, shift)) {
  petsc(KSPCreate(PETSC_COMM_SELF, solver_.out()));
  petsc(KSPSetOptionsPrefix(solver_, "residual_"));
  petsc(KSPSetOperators(solver_, matrix_, matrix_));
  petsc(KSPSetType(solver_, KSPPREONLY));
  PC factors = nullptr;
  petsc(KSPGetPC(solver_, &factors));
  petsc(PCSetType(factors, PCCHOLESKY));
  petsc(PCFactorSetMatSolverType(factors, MATSOLVERMUMPS));
  petsc(KSPSetFromOptions(solver_));
  petsc(KSPSetUp(solver_));
  petsc(PCFactorGetMatrix(factors, &factored_));
}

void ShiftedStiffness::solve(PetscInt columns, const std::function<parallel::Handle<Vec>(PetscInt column)>& right,
                             const std::function<void(PetscInt column, Vec right, Vec solution)>& take) const {
  parallel::Handle<Mat> rights;
  parallel::Handle<Mat> solutions;
  petsc(MatCreateSeqDense(PETSC_COMM_SELF, operators_.size(), columns, nullptr, rights.out()));
  petsc(MatCreateSeqDense(PETSC_COMM_SELF, operators_.size(), columns, nullptr, solutions.out()));
  for (PetscInt i = 0; i < columns; ++i) {
    const parallel::Handle<Vec> values = right(i);
    Vec column = nullptr;
    petsc(MatDenseGetColumnVecWrite(rights, i, &column));
    petsc(VecCopy(values, column));
    petsc(MatDenseRestoreColumnVecWrite(rights, i, &column));
  }
  petsc(MatMatSolve(factored_, rights, solutions));
  for (PetscInt i = 0; i < columns; ++i) {
    Vec given = nullptr;
    Vec solution = nullptr;
    petsc(MatDenseGetColumnVecRead(rights, i, &given));
    petsc(MatDenseGetColumnVecRead(solutions, i, &solution));
    take(i, given, solution);
    petsc(MatDenseRestoreColumnVecRead(solutions, i, &solution));
    petsc(MatDenseRestoreColumnVecRead(rights, i, &given));
  }
}

std::vector<double> ShiftedStiffness::flexibilities(std::span<const Index> nodes,
                                                    std::span<const Vector3> directions) const {
  std::vector<double> found(nodes.size());
  solve(
      static_cast<PetscInt>(nodes.size()),
      [&](PetscInt i) {
        std::vector<double> field(3 * operators_.support().size());
        Vector3::Map(&field[3 * static_cast<std::size_t>(nodes[i])]) = directions[i];
        return operators_.restricted(field);
      },
      [&](PetscInt i, Vec force, Vec displacement) { petsc(VecDot(force, displacement, &found[i])); });
  return found;
}

Eigen::MatrixXd ShiftedStiffness::displacements(const Eigen::MatrixXd& forces) const {
  Eigen::MatrixXd found(forces.rows(), forces.cols());
  solve(
      static_cast<PetscInt>(forces.cols()),
      [&](PetscInt i) {
        return operators_.restricted({forces.col(i).begin(), forces.col(i).end()});
      },
      [&](PetscInt i, Vec /*force*/, Vec displacement) {
        const std::vector<double> field = operators_.extended(displacement);
        found.col(i) = Eigen::Map<const Eigen::VectorXd>(field.data(), std::ssize(field));
      });
  return found;
}

}  // namespace idiophone::eigenmodes
