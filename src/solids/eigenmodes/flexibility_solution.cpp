#include "flexibility_solution.hpp"

#include <petscksp.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>

#include "idiophone/foundation/inertia_tensor.hpp"
#include "idiophone/foundation/parallel/petsc.hpp"

namespace idiophone::eigenmodes {

using parallel::petsc;

namespace {

/// Factors of K + shift M.
class ShiftedStiffness {
 public:
  ShiftedStiffness(const Operators& operators, double shift) : operators_(operators) {
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

  /// The displacements along unit forces, each at a node by itself, m/N. Many at once are several times as fast.
  [[nodiscard]] std::vector<double> flexibilities(std::span<const Index> nodes,
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

 private:
  const Operators& operators_;
  parallel::Handle<Mat> matrix_;
  parallel::Handle<KSP> solver_;
  Mat factored_ = nullptr;  // the solver's
};

/// How a force accelerates a free body at a node, along it, 1/kg.
class RigidMobility {
 public:
  RigidMobility(const modal_bodies::ModalBasis& basis, const mesh::Part& part) {
    for (std::size_t node = 0; node < basis.nodes(); ++node) {
      mass_ += basis.masses[node];
      centre_ += basis.masses[node] * part.reference[node];
    }
    centre_ /= mass_;
    Eigen::Matrix3d moment = Eigen::Matrix3d::Zero();
    for (std::size_t node = 0; node < basis.nodes(); ++node) {
      const Vector3 arm = part.reference[node] - centre_;
      moment += basis.masses[node] * arm * arm.transpose();
    }
    inverse_inertia_ = inertia_tensor(moment).inverse();
  }

  [[nodiscard]] double at(const Vector3& place, const Vector3& direction) const {
    const Vector3 torque = (place - centre_).cross(direction);
    return 1 / mass_ + torque.dot(inverse_inertia_ * torque);
  }

 private:
  double mass_ = 0.0;
  Vector3 centre_ = Vector3::Zero();
  Eigen::Matrix3d inverse_inertia_;
};

}  // namespace

std::vector<double> residual_flexibility(const Operators& operators, const mesh::Part& part,
                                         const modal_bodies::ModalBasis& basis, std::span<const Index> nodes,
                                         std::span<const Vector3> directions, double shift) {
  constexpr std::size_t at_once = 128;
  const ShiftedStiffness stiffness(operators, shift);
  const RigidMobility rigid(basis, part);
  std::vector<double> residual(basis.nodes());
  std::vector<double> whole;
  for (std::size_t i = 0; i < nodes.size(); i += at_once) {
    const std::size_t count = std::min(at_once, nodes.size() - i);
    std::ranges::copy(stiffness.flexibilities(nodes.subspan(i, count), directions.subspan(i, count)),
                      std::back_inserter(whole));
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Index node = nodes[i];
    const Vector3& direction = directions[i];
    double left = whole[i];
    left -= basis.is_free ? rigid.at(part.reference[node], direction) / shift : 0.0;
    for (std::size_t mode = 0; mode < basis.modes(); ++mode) {
      const double along = direction.dot(Vector3::Map(&basis.shapes[3 * (mode * basis.nodes() + node)]));
      left -= along * along / (basis.frequencies[mode] * basis.frequencies[mode] + shift);
    }
    residual[node] = std::max(0.0, left);
  }
  return residual;
}

}  // namespace idiophone::eigenmodes
