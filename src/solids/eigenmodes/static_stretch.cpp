#include "static_stretch.hpp"

#include "idiophone/foundation/dense/dense.hpp"

namespace idiophone::eigenmodes {

namespace {

Eigen::Map<const Eigen::VectorXd> as_vector(const std::vector<double>& values) {
  return {values.data(), std::ssize(values)};
}

}  // namespace

Eigen::MatrixXd orthonormal(const std::vector<std::vector<double>>& rigid, const Eigen::VectorXd& masses) {
  Eigen::MatrixXd motions(masses.size(), std::ssize(rigid));
  for (std::size_t motion = 0; motion < rigid.size(); ++motion) {
    motions.col(static_cast<Eigen::Index>(motion)) = as_vector(rigid[motion]);
  }
  return motions * dense::inverse_root(motions.transpose() * masses.asDiagonal() * motions);
}

StaticStretch::StaticStretch(const ShiftedStiffness& stiffness, const StrainSpace& space,
                             const modal_bodies::ModalBasis& basis, const std::vector<std::vector<double>>& rigid)
    : space_(space),
      stiffness_(stiffness),
      masses_(as_vector(basis.masses).transpose().replicate<3, 1>().reshaped()),
      kept_(masses_.size(), std::ssize(rigid) + std::ssize(basis.frequencies)) {
  if (!rigid.empty()) {
    kept_.leftCols(std::ssize(rigid)) = orthonormal(rigid, masses_);
  }
  kept_.rightCols(std::ssize(basis.frequencies)) =
      as_vector(basis.shapes).reshaped(masses_.size(), std::ssize(basis.frequencies));
}

Eigen::MatrixXd StaticStretch::remainders(const Eigen::MatrixXd& strains) const {
  Eigen::MatrixXd forces = -space_.forces(strains);
  forces -= masses_.asDiagonal() * (kept_ * (kept_.transpose() * forces)).eval();
  Eigen::MatrixXd stretches = stiffness_.displacements(forces);
  stretches -= kept_ * (kept_.transpose() * (masses_.asDiagonal() * stretches)).eval();
  return strains + space_.linear(stretches);
}

}  // namespace idiophone::eigenmodes
