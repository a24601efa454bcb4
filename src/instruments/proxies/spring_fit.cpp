#include "idiophone/instruments/proxies/spring_fit.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <utility>

#include "frequency_bound.hpp"
#include "modal_response.hpp"

namespace idiophone::proxies {

namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

constexpr double softest = 0.02, stiffest = 3.0;  // factors
constexpr double reluctance = 1e-3;     // weight of a logarithm that changes by 1, over a flexibility that errs by 1
constexpr double share_of_pairs = 0.3;  // weight of what two modes do to each other, over that of one mode

/// What the fit makes small, and how it changes.
struct Misfit {
  Vector values;  ///< [pairs of modes]
  Matrix slopes;  ///< [springs x pairs of modes] by the logarithms of the factors
};

/// Of factors, as logarithms. [springs]
struct Limits {
  Vector least, most;
};

/// The fit of one lattice.
class Fit {
 public:
  Fit(const Lattice& lattice, const ModalResponse& response) : response_(response) {
    stiffness_.resize(std::ssize(lattice.springs()));
    std::ranges::transform(lattice.springs(), stiffness_.begin(), &Spring::stiffness);
    const Vector& squares = response.known_squares();
    weights_ = (squares[0] / squares.array()).sqrt().sqrt();
  }

  [[nodiscard]] Vector stiffness(const Vector& logarithms) const {
    return stiffness_.cwiseProduct(logarithms.array().exp().matrix());
  }

  [[nodiscard]] Misfit misfit(const Vector& logarithms) const {
    const Vector stiffness = this->stiffness(logarithms);
    const auto [matrix, elongations] = response_.flexibility(stiffness);
    const Eigen::Index modes = matrix.cols();
    Misfit misfit{.values = Vector(modes * (modes + 1) / 2),
                  .slopes = Matrix(stiffness.size(), modes * (modes + 1) / 2)};
    for (Eigen::Index i = 0, pair = 0; i < modes; ++i) {
      for (Eigen::Index j = 0; j <= i; ++j, ++pair) {
        const double weight = (i == j ? 1.0 : share_of_pairs) * weights_[i] * weights_[j];
        misfit.values[pair] = weight * (matrix(i, j) - (i == j ? 1.0 : 0.0));
        misfit.slopes.col(pair) = -weight * stiffness.cwiseProduct(elongations.col(i)).cwiseProduct(elongations.col(j));
      }
    }
    return misfit;
  }

  /// The factor, the same for all springs, that brings the modes closest; not above 1.
  [[nodiscard]] double common_factor() const {
    return std::min(std::exp(response_.flexibility(stiffness_).matrix.diagonal().array().log().mean()), 1.0);
  }

 private:
  const ModalResponse& response_;
  Vector stiffness_;  ///< [springs] of the lattice, N/m
  Vector weights_;    ///< [modes] high ones matter less: their weights fall as 1/sqrt(w)
};

/// A spring may become as stiff as its masses allow without a larger bound of the frequencies.
Limits limits_of(const Lattice& lattice) {
  const std::vector<double> bounds =
      frequency_bounds(lattice.mesh().nodes, lattice.springs(), lattice.masses(), lattice.pinned());
  const double largest = std::ranges::max(bounds);
  const auto count = std::ssize(lattice.springs());
  Limits limits{.least = Vector::Constant(count, std::log(softest)), .most = Vector(count)};
  for (Eigen::Index s = 0; s < count; ++s) {
    const Spring& spring = lattice.springs()[s];
    const double bound = std::max(bounds[spring.a], bounds[spring.b]);
    limits.most[s] = std::log(bound * stiffest < largest ? stiffest : largest / bound);
  }
  return limits;
}

/// The y within limits that minimizes |misfit + slopes (y - x)|^2 + weight |y - centre|^2: springs that would leave the
/// limits stay there, and the others make up for them.
Vector minimum_within(const Limits& limits, const Misfit& misfit, const Vector& x, const Vector& centre,
                      double weight) {
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
    y = wanted.cwiseMax(limits.least).cwiseMin(limits.most);
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
Vector fitted(const Fit& fit, const Limits& limits, Vector x, const Vector& centre) {
  constexpr int most_trials = 25;
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
    const Vector next = minimum_within(limits, misfit, x, between, inertia + damping);
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
  const Fit fit(lattice, response);
  const Limits limits = limits_of(lattice);
  const Vector even =
      Vector::Constant(limits.least.size(), std::log(fit.common_factor())).cwiseMax(limits.least).cwiseMin(limits.most);
  const Vector near = fitted(fit, limits, even, even);
  response.turn_to_modes(fit.stiffness(near));
  const Vector logarithms = fitted(fit, limits, near, even);
  const auto cents_with = [&](const Vector& x) {
    return cents(response.lowest_squares(fit.stiffness(x)), response.known_squares());
  };
  return {.edges = edges_of(lattice, logarithms),
          .before = cents_with(Vector::Zero(logarithms.size())),
          .after = cents_with(logarithms)};
}

}  // namespace idiophone::proxies
