#include "joined_shapes.hpp"

#include <cmath>

#include "idiophone/foundation/dense/dense.hpp"

namespace idiophone::eigenmodes {

using parallel::petsc;

Eigen::MatrixXd product(Mat matrix, const Operators& operators, const Eigen::MatrixXd& fields) {
  Eigen::MatrixXd result(fields.rows(), fields.cols());
  for (Eigen::Index column = 0; column < fields.cols(); ++column) {
    const std::vector<double> field(fields.col(column).begin(), fields.col(column).end());
    const parallel::Handle<Vec> in = operators.restricted(field);
    parallel::Handle<Vec> out;
    petsc(VecDuplicate(in, out.out()));
    petsc(MatMult(matrix, in, out));
    const std::vector<double> values = operators.extended(out);
    result.col(column) = Eigen::VectorXd::Map(values.data(), std::ssize(values));
  }
  return result;
}

namespace {

/// What rigid motions and modes lack of the joined motion, for modes of the assembly with the energy 1/2 J.
Eigen::MatrixXd remainders(const Operators& operators, const Modes& found,
                           const std::vector<std::vector<double>>& rigid, const JoinedMotion& motion) {
  const auto rows = std::ssize(motion.shapes.front());
  Eigen::MatrixXd known(rows, std::ssize(rigid) + std::ssize(found.modes));
  Eigen::Index column = 0;
  for (const std::vector<double>& field : rigid) {
    known.col(column++) = Eigen::VectorXd::Map(field.data(), rows);
  }
  for (const Mode& mode : found.modes) {
    known.col(column++) = Eigen::VectorXd::Map(mode.shape.data(), rows);
  }
  Eigen::MatrixXd left(rows, std::ssize(motion.shapes));
  for (Eigen::Index mode = 0; mode < left.cols(); ++mode) {
    left.col(mode) = Eigen::VectorXd::Map(motion.shapes[mode].data(), rows) / motion.frequencies[mode];
  }
  const Eigen::MatrixXd weighted = product(operators.mass(), operators, known);
  const Eigen::MatrixXd root = dense::inverse_root(weighted.transpose() * known);
  const Eigen::MatrixXd inverse = root * root;
  for (int twice = 0; twice < 2; ++twice) {
    left -= known * (inverse * (weighted.transpose() * left));
  }
  return left;
}

/// The combinations of the columns whose energy is not small, of unit energy.
/// @param energies  of the columns with each other
Eigen::MatrixXd strongest(const Eigen::MatrixXd& energies) {
  constexpr double small = 1e-6;  // of the energy of a mode of the assembly
  const auto [values, vectors] = dense::eigenpairs(energies);
  const auto kept = (values.array() > small).count();
  return vectors.rightCols(kept) * values.tail(kept).cwiseSqrt().cwiseInverse().asDiagonal();
}

}  // namespace

std::vector<Eigenpair> joined_shapes(const Operators& operators, const Modes& found,
                                     const std::vector<std::vector<double>>& rigid, const JoinedMotion& motion) {
  const Eigen::MatrixXd left = remainders(operators, found, rigid, motion);
  const Eigen::ArrayXd springs = Eigen::ArrayXd::Map(motion.springs.data(), std::ssize(motion.springs));
  const Eigen::VectorXd at_components = springs.transpose().replicate(3, 1).reshaped();
  const Eigen::MatrixXd stiff = product(operators.stiffness(), operators, left);
  const Eigen::MatrixXd energies = left.transpose() * stiff + left.transpose() * (at_components.asDiagonal() * left);
  const Eigen::MatrixXd directions = strongest((energies + energies.transpose()) / 2);
  if (directions.cols() == 0) {
    return {};
  }
  const Eigen::MatrixXd basis = left * directions;
  const Eigen::MatrixXd mass = basis.transpose() * product(operators.mass(), operators, basis);
  const Eigen::MatrixXd root = dense::inverse_root((mass + mass.transpose()) / 2);
  const Eigen::MatrixXd stiffness = root * (directions.transpose() * (left.transpose() * stiff) * directions) * root;
  const auto [values, vectors] = dense::eigenpairs(Eigen::MatrixXd((stiffness + stiffness.transpose()) / 2));
  const Eigen::MatrixXd shapes = basis * (root * vectors);
  std::vector<Eigenpair> pairs;
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    const Eigen::VectorXd shape = shapes.col(i);
    pairs.push_back({.value = values[i], .vector = std::vector<double>(shape.begin(), shape.end())});
  }
  return pairs;
}

}  // namespace idiophone::eigenmodes
