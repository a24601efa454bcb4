#include "residual_flexibility.hpp"

#include <petscksp.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>

#include "idiophone/parallel/petsc.hpp"

namespace idiophone::modes {

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
    petsc(MatCreateVecs(matrix_, solution_.out(), force_.out()));
  }

  /// The displacement along a unit force at a node, m/N.
  double flexibility(Index node, const Vector3& direction) {
    std::vector<double> field(3 * operators_.support().size());
    Vector3::Map(&field[3 * node]) = direction;
    const parallel::Handle<Vec> force = operators_.restricted(field);
    petsc(KSPSolve(solver_, force, solution_));
    PetscScalar product = 0.0;
    petsc(VecDot(force, solution_, &product));
    return product;
  }

 private:
  const Operators& operators_;
  parallel::Handle<Mat> matrix_;
  parallel::Handle<KSP> solver_;
  parallel::Handle<Vec> solution_;
  parallel::Handle<Vec> force_;
};

/// How a force accelerates a free body at a node, along it, 1/kg.
class RigidMobility {
 public:
  RigidMobility(const motion::ModalBasis& basis, const mesh::Part& part) {
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
    inverse_inertia_ = Eigen::Matrix3d(moment.trace() * Eigen::Matrix3d::Identity() - moment).inverse();
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
                                         const motion::ModalBasis& basis, std::span<const Index> nodes,
                                         std::span<const Vector3> directions, double shift) {
  ShiftedStiffness stiffness(operators, shift);
  const RigidMobility rigid(basis, part);
  std::vector<double> residual(basis.nodes());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Index node = nodes[i];
    const Vector3& direction = directions[i];
    double left = stiffness.flexibility(node, direction);
    left -= basis.is_free ? rigid.at(part.reference[node], direction) / shift : 0.0;
    for (std::size_t mode = 0; mode < basis.modes(); ++mode) {
      const double along = direction.dot(Vector3::Map(&basis.shapes[3 * (mode * basis.nodes() + node)]));
      left -= along * along / (basis.frequencies[mode] * basis.frequencies[mode] + shift);
    }
    residual[node] = std::max(0.0, left);
  }
  return residual;
}

}  // namespace idiophone::modes
