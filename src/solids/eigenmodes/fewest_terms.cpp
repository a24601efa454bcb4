#include "fewest_terms.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <numbers>

#include "idiophone/foundation/dense/dense.hpp"
#include "quartimax.hpp"

namespace idiophone::eigenmodes {

namespace {

/// H as q of the variance 1 see it.
/// @param quadratic  H, [modes x modes, terms]
/// @param roots      of the variances of q, [modes]
Eigen::MatrixXd weighted(const Eigen::MatrixXd& quadratic, const Eigen::VectorXd& roots) {
  const Eigen::VectorXd weights = (roots * roots.transpose()).reshaped();
  return weights.asDiagonal() * quadratic;
}

/// Each pair of modes once, with the same energy as both orders of it. [pairs, terms]
/// @param quadratic, roots  as above
Eigen::MatrixXd pairs_seen(const Eigen::MatrixXd& quadratic, const Eigen::VectorXd& roots) {
  const Eigen::Index modes = roots.size();
  const Eigen::MatrixXd seen = weighted(quadratic, roots);
  Eigen::MatrixXd pairs(modes * (modes + 1) / 2, seen.cols());
  for (Eigen::Index mode = 0, pair = 0; mode < modes; pair += ++mode) {
    pairs.middleRows(pair, mode + 1) = std::numbers::sqrt2 * seen.middleRows(mode * modes, mode + 1);
    pairs.row(pair + mode) /= std::numbers::sqrt2;
  }
  return pairs;
}

/// [terms x terms] Mean of z_m z_n. For q of the variances D, it is tr(H_m D) tr(H_n D) + 2 tr(H_m D H_n D).
/// @param quadratic, roots  as above
Eigen::MatrixXd mean_products(const Eigen::MatrixXd& quadratic, const Eigen::VectorXd& roots) {
  const Eigen::MatrixXd seen = weighted(quadratic, roots);
  const Eigen::VectorXd identity = Eigen::MatrixXd::Identity(roots.size(), roots.size()).reshaped();
  const Eigen::VectorXd traces = seen.transpose() * identity;
  return traces * traces.transpose() + 2 * seen.transpose() * seen;
}

/// How many of the last values are needed so that the others have at most a share of the sum.
/// @param values  ascending
Eigen::Index enough(const Eigen::VectorXd& values, double share) {
  const double most = share * values.sum();
  Eigen::Index left_out = 0;
  for (double sum = values[0]; left_out + 1 < values.size() && sum <= most; sum += values[left_out]) {
    ++left_out;
  }
  return values.size() - left_out;
}

/// Along other strains, symmetric in spite of rounding.
Eigen::MatrixXd turned(const Eigen::MatrixXd& quadratic, const Eigen::MatrixXd& directions, Eigen::Index modes) {
  Eigen::MatrixXd result = quadratic * directions;
  for (Eigen::Index term = 0; term < result.cols(); ++term) {
    const Eigen::MatrixXd matrix = result.col(term).reshaped(modes, modes);
    result.col(term) = ((matrix + matrix.transpose()) / 2).reshaped();
  }
  return result;
}

/// Leaves out the smallest numbers, those of pairs of modes that have at most a share of the mean energy together.
/// @param quadratic  as above; entry (i, j) of a term has the energy (H_ij)^2 D_i D_j, but for a factor
Eigen::MatrixXd without_smallest(const Eigen::MatrixXd& quadratic, const Eigen::VectorXd& roots, double share) {
  const Eigen::MatrixXd energies = weighted(quadratic, roots).cwiseAbs2();
  Eigen::VectorXd sorted = energies.reshaped();
  std::ranges::sort(sorted);
  const double most = share * energies.sum();
  double left_out = sorted[0], limit = 0.0;
  for (Eigen::Index i = 1; i < sorted.size() && left_out <= most; left_out += sorted[i], ++i) {
    limit = sorted[i - 1];
  }
  return (energies.array() <= limit).select(0.0, quadratic);
}

}  // namespace

modal_bodies::Stretching in_fewest_terms(const modal_bodies::Stretching& stretching,
                                         const std::vector<double>& frequencies, double tolerance) {
  const auto modes = std::ssize(frequencies);
  const auto terms = static_cast<Eigen::Index>(stretching.terms());
  const Eigen::Map<const Eigen::MatrixXd> linear(stretching.linear.data(), modes, terms);
  const Eigen::Map<const Eigen::MatrixXd> quadratic(stretching.quadratic.data(), modes * modes, terms);
  const Eigen::VectorXd roots = Eigen::Map<const Eigen::VectorXd>(frequencies.data(), modes).cwiseInverse();
  const auto [energies, directions] = dense::eigenpairs(mean_products(quadratic, roots));
  const Eigen::MatrixXd strongest = directions.rightCols(enough(energies, tolerance / 2)).rowwise().reverse();
  const Eigen::MatrixXd kept = quartimax(strongest, pairs_seen(quadratic * strongest, roots));
  modal_bodies::Stretching fewer;
  fewer.linear.resize(static_cast<std::size_t>(modes * kept.cols()));
  fewer.quadratic.resize(static_cast<std::size_t>(modes * modes * kept.cols()));
  Eigen::Map<Eigen::MatrixXd>(fewer.linear.data(), modes, kept.cols()) = linear * kept;
  Eigen::Map<Eigen::MatrixXd>(fewer.quadratic.data(), modes * modes, kept.cols()) =
      without_smallest(turned(quadratic, kept, modes), roots, tolerance / 2);
  fewer.rotation = stretching.rotation;
  return fewer;
}

}  // namespace idiophone::eigenmodes
