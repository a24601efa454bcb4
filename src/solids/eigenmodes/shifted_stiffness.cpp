#include "shifted_stiffness.hpp"

namespace idiophone::eigenmodes {

using parallel::petsc;

ShiftedStiffness::ShiftedStiffness(const Operators& operators, double shift) : operators_(operators) {
  petsc(MatDuplicate(operators.stiffness(), MAT_COPY_VALUES, matrix_.out()));
  petsc(MatAXPY(matrix_, shift, operators.mass(), SUBSET_NONZERO_PATTERN));
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

std::vector<double> ShiftedStiffness::flexibilities(std::span<const Index> nodes,
                                                    std::span<const Vector3> directions) const {
  parallel::Handle<Mat> forces;
  parallel::Handle<Mat> displacements;
  const auto count = static_cast<PetscInt>(nodes.size());
  petsc(MatCreateSeqDense(PETSC_COMM_SELF, operators_.size(), count, nullptr, forces.out()));
  petsc(MatCreateSeqDense(PETSC_COMM_SELF, operators_.size(), count, nullptr, displacements.out()));
  for (PetscInt i = 0; i < count; ++i) {
    std::vector<double> field(3 * operators_.support().size());
    Vector3::Map(&field[3 * static_cast<std::size_t>(nodes[i])]) = directions[i];
    const parallel::Handle<Vec> force = operators_.restricted(field);
    Vec column = nullptr;
    petsc(MatDenseGetColumnVecWrite(forces, i, &column));
    petsc(VecCopy(force, column));
    petsc(MatDenseRestoreColumnVecWrite(forces, i, &column));
  }
  petsc(MatMatSolve(factored_, forces, displacements));
  std::vector<double> found(nodes.size());
  for (PetscInt i = 0; i < count; ++i) {
    Vec force = nullptr;
    Vec displacement = nullptr;
    petsc(MatDenseGetColumnVecRead(forces, i, &force));
    petsc(MatDenseGetColumnVecRead(displacements, i, &displacement));
    petsc(VecDot(force, displacement, &found[i]));
    petsc(MatDenseRestoreColumnVecRead(displacements, i, &displacement));
    petsc(MatDenseRestoreColumnVecRead(forces, i, &force));
  }
  return found;
}

std::vector<double> ShiftedStiffness::displacements(const std::vector<double>& forces) const {
  const parallel::Handle<Vec> force = operators_.restricted(forces);
  parallel::Handle<Vec> displacement;
  petsc(VecDuplicate(force, displacement.out()));
  petsc(MatSolve(factored_, force, displacement));
  return operators_.extended(displacement);
}

}  // namespace idiophone::eigenmodes
