#include "idiophone/instruments/proxies/spring_fit.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "modal_response.hpp"
#include "stiffness_limit.hpp"

namespace idiophone::proxies {

namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

constexpr double softest = 0.02, stiffest = 10.0;  // factors
constexpr double reluctance = 1e-3;     // weight of a logarithm that changes by 1, over a flexibility that errs by 1
constexpr double share_of_pairs = 0.3;  // weight of what two modes do to each other, over that of one mode

/// The fit of one lattice.
class Fit {
 public:
  /// @param share_of_shapes  weight of the energies that shapes store, over that of flexibilities
  Fit(const Lattice& lattice, const ModalResponse& response, const StiffnessLimit& limit, double share_of_shapes)
      : response_(response), limit_(limit), share_of_shapes_(share_of_shapes) {
    stiffness_.resize(std::ssize(lattice.springs()));
    std::ranges::transform(lattice.springs(), stiffness_.begin(), &Spring::stiffness);
    const Vector& squares = response.known_squares();
    weights_ = (squares[0] / squares.array()).sqrt().sqrt();
    if (share_of_shapes > 0.0) {
      of_shapes_ = response.elongations_of_shapes();
    }
  }

  [[nodiscard]] Vector stiffness(const Vector& logarithms) const {
    return stiffness_.cwiseProduct(logarithms.array().exp().matrix());
  }

  [[nodiscard]] Vector logarithms(const Vector& stiffness) const {
    return stiffness.cwiseQuotient(stiffness_).array().log();
  }

  [[nodiscard]] Misfit misfit(const Vector& logarithms) const {
    const Vector stiffness = this->stiffness(logarithms);
    const auto [matrix, elongations] = response_.flexibility(stiffness);
    std::vector<Misfit> parts = {from_identity(matrix, elongations, -stiffness, 1.0), limit_.excess(stiffness)};
    if (share_of_shapes_ > 0.0) {
      const Matrix energies = of_shapes_.transpose() * stiffness.asDiagonal() * of_shapes_;
      parts.push_back(from_identity(energies, of_shapes_, stiffness, share_of_shapes_));
    }
    return joined(parts);
  }

  /// The factor, the same for all springs, that brings the modes closest; not above 1.
  [[nodiscard]] double common_factor() const {
    return std::min(std::exp(response_.flexibility(stiffness_).matrix.diagonal().array().log().mean()), 1.0);
  }

 private:
  /// @param matrix  [modes x modes] whose entry ij changes by the sum of change e_i e_j over the springs
  [[nodiscard]] Misfit from_identity(const Matrix& matrix, const Matrix& elongations, const Vector& change,
                                     double share) const {
    const Eigen::Index modes = matrix.cols();
    Misfit misfit{.values = Vector(modes * (modes + 1) / 2), .slopes = Matrix(change.size(), modes * (modes + 1) / 2)};
    for (Eigen::Index i = 0, pair = 0; i < modes; ++i) {
      for (Eigen::Index j = 0; j <= i; ++j, ++pair) {
        const double weight = share * (i == j ? 1.0 : share_of_pairs) * weights_[i] * weights_[j];
        misfit.values[pair] = weight * (matrix(i, j) - (i == j ? 1.0 : 0.0));
        misfit.slopes.col(pair) = weight * change.cwiseProduct(elongations.col(i)).cwiseProduct(elongations.col(j));
      }
    }
    return misfit;
  }

  [[nodiscard]] static Misfit joined(const std::vector<Misfit>& parts) {
    Eigen::Index residuals = 0;
    for (const Misfit& part : parts) {
      residuals += part.values.size();
    }
    Misfit whole{.values = Vector(residuals), .slopes = Matrix(parts.front().slopes.rows(), residuals)};
    Eigen::Index first = 0;
    for (const Misfit& part : parts) {
      whole.values.segment(first, part.values.size()) = part.values;
      whole.slopes.middleCols(first, part.values.size()) = part.slopes;
      first += part.values.size();
    }
    return whole;
  }

  const ModalResponse& response_;
  const StiffnessLimit& limit_;
  double share_of_shapes_;
  Matrix of_shapes_;  ///< [springs x modes] elongations by the shapes as they are now; empty if they don't count
  Vector stiffness_;  ///< [springs] of the lattice, N/m
  Vector weights_;    ///< [modes] high ones matter less: their weights fall as 1/sqrt(w)
};

/// The y within limits that minimizes |misfit + slopes (y - x)|^2 + weight |y - centre|^2: springs that would leave the
/// limits stay there, and the others make up for them.
Vector minimum_within_limits(const Misfit& misfit, const Vector& x, const Vector& centre, double weight) {
  constexpr int most_rounds = 8;
  Vector y = centre;
  Vector is_free = Vector::Ones(x.size());
  for (int round = 0; round < most_rounds; ++round) {
    const Vector begin = is_free.cwiseProduct(centre) + (Vector::Ones(x.size()) - is_free).cwiseProduct(y);
    const Vector left = misfit.values + misfit.slopes.transpose() * (begin - x);
    const Matrix slopes = is_free.asDiagonal() * misfit.slopes;
    Matrix products = weight * Matrix::Identity(left.size(), left.size());
    products.selfadjointView<Eigen::Lower>().rankUpdate(slopes.transpose());
    const Vector wanted = begin - slopes * products.selfadjointView<Eigen::Lower>().llt().solve(left);
    y = wanted.cwiseMax(std::log(softest)).cwiseMin(std::log(stiffest));
    const auto stays = (y.array() == wanted.array()).cast<double>();
    if (stays.minCoeff() == 1.0) {
      break;
    }
    is_free.array() *= stays;
  }
  return y;
}

/// Logarithms of the factors, by Levenberg's and Marquardt's method.
/// @param x       where it begins
/// @param centre  from where changes are counted
Vector fitted(const Fit& fit, Vector x, const Vector& centre) {
  constexpr int most_trials = 50;
  constexpr double first_damping = 1e-2, least_damping = 1e-12, largest_damping = 1e6;
  constexpr double enough = 1e-3;  // relative decrease in an iteration
  const double inertia = reluctance * reluctance;
  const auto cost_of = [&](const Misfit& there, const Vector& place) {
    return there.values.squaredNorm() + inertia * (place - centre).squaredNorm();
  };
  Misfit misfit = fit.misfit(x);
  double cost = cost_of(misfit, x), damping = first_damping;
  for (int iteration = 0; iteration < most_trials && damping < largest_damping; ++iteration) {
    const Vector between = (inertia * centre + damping * x) / (inertia + damping);
    const Vector next = minimum_within_limits(misfit, x, between, inertia + damping);
    Misfit of_next = fit.misfit(next);
    const double next_cost = cost_of(of_next, next);
    if (!(next_cost < cost)) {
      damping *= 16.0;
      continue;
    }
    const bool is_done = cost - next_cost < enough * cost;
    x = next;
    misfit = std::move(of_next);
    cost = next_cost;
    damping = std::max(damping / 9.0, least_damping);
    if (is_done) {
      break;
    }
  }
  return x;
}

std::vector<EdgeFactors> edges_of(const Lattice& lattice, const Vector& logarithms) {
  const auto masses_of = [](const Spring& spring) { return std::pair(spring.a, spring.b); };
  std::vector<EdgeFactors> edges;
  for (const auto& corners : lattice.mesh().tetrahedra) {
    EdgeFactors& factors = edges.emplace_back();
    std::size_t edge = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = i + 1; j < 4; ++j) {
        const std::pair<Index, Index> masses = std::minmax(corners[i], corners[j]);
        const auto spring = std::ranges::lower_bound(lattice.springs(), masses, {}, masses_of);
        factors[edge++] = std::exp(logarithms[spring - lattice.springs().begin()]);
      }
    }
  }
  return edges;
}

std::vector<double> cents(const Vector& squares, const Vector& known) {
  const Vector result = 600.0 * (squares.array() / known.array()).log() / std::log(2.0);
  return {result.begin(), result.end()};
}

}  // namespace

std::size_t modes_to_fit(const Lattice& lattice) {
  constexpr double most = 24.0;
  return static_cast<std::size_t>(std::min(std::sqrt(static_cast<double>(lattice.springs().size())), most));
}

SpringFit fit_springs(const Lattice& lattice, std::span<const KnownMode> modes) {
  ModalResponse response(lattice, modes);
  const StiffnessLimit limit(lattice);
  constexpr double weight_of_shapes = 0.05;  // of their energies beside the frequencies, in the first stage
  const Fit with_shapes(lattice, response, limit, weight_of_shapes), fit(lattice, response, limit, 0.0);
  const Vector even = Vector::Constant(std::ssize(lattice.springs()), std::log(std::max(fit.common_factor(), softest)));
  Vector logarithms = fitted(with_shapes, even, even);
  constexpr int turns = 2;  // the fit changes the lattice's modes, so that the first turn is not the last one
  for (int turn = 0; turn < turns; ++turn) {
    response.turn_to_modes(fit.stiffness(logarithms));
    logarithms = fitted(fit, logarithms, even);
  }
  logarithms = fit.logarithms(limit.held(fit.stiffness(logarithms)));
  const auto cents_with = [&](const Vector& x) {
    return cents(response.lowest_squares(fit.stiffness(x)), response.known_squares());
  };
  return {.edges = edges_of(lattice, logarithms),
          .before = cents_with(Vector::Zero(logarithms.size())),
          .after = cents_with(logarithms)};
}

}  // namespace idiophone::proxies
