// The 95 % intervals against a sample of the posterior distribution, which is nowhere taken as normal.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <random>
#include <vector>

#include "elastic_constants.hpp"
#include "matched_fit.hpp"
#include "material_fit.hpp"
#include "noisy_blocks.hpp"
#include "ranks.hpp"

namespace idiophone::fitting {
namespace {

using Eigen::VectorXd;

/// The logarithm of a probability density, but for a constant.
using LogDensity = std::function<double(const VectorXd& point)>;

/// Points of a distribution by the stretch moves of an ensemble, which no linear transformation of the unknowns
/// changes: Goodman and Weare 2010, section 2. The first fifth of the moves is left out.
/// @param spread  of the ensemble at the start
std::vector<VectorXd> sample(const LogDensity& density, const VectorXd& start, const VectorXd& spread, int moves) {
  constexpr int walkers = 40;
  constexpr double widest = 2.0;  // stretch
  std::mt19937 generator(37);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::normal_distribution<double> normal;
  std::vector<VectorXd> ensemble;
  std::vector<double> densities;
  for (int w = 0; w < walkers; ++w) {
    ensemble.push_back(start +
                       spread.cwiseProduct(VectorXd::NullaryExpr(start.size(), [&] { return normal(generator); })));
    densities.push_back(density(ensemble.back()));
  }
  std::vector<VectorXd> points;
  for (int move = 0; move < moves; ++move) {
    for (int w = 0; w < walkers; ++w) {
      const int other = (w + 1 + static_cast<int>(uniform(generator) * (walkers - 1))) % walkers;
      const double stretch = std::pow(1 + (widest - 1) * uniform(generator), 2) / widest;
      const VectorXd next = ensemble[other] + stretch * (ensemble[w] - ensemble[other]);
      const double there = density(next);
      const double dimensions = static_cast<double>(start.size()) - 1;
      if (std::log(uniform(generator)) < dimensions * std::log(stretch) + there - densities[w]) {
        ensemble[w] = next;
        densities[w] = there;
      }
      if (move >= moves / 5) {
        points.push_back(ensemble[w]);
      }
    }
  }
  return points;
}

/// Half the distance between the values that 2.5 % are below and above.
double half_width_of(std::vector<double> values) {
  std::ranges::sort(values);
  const auto at = [&](double share) {
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size()))];
  };
  return (at(0.975) - at(0.025)) / 2;
}

ON_RANKS(1);

// The residuals of this block are no larger than by chance. The frequencies of the model are not linear in the
// unknowns.
TEST(Posterior, HasTheIntervalsOfAnEnsembleMonteCarlo) {
  std::mt19937 generator(37);
  StrainedBody body = reduced_block();
  const scene::Material metal{"metal", 6.6e10, 0.3, 2700, {}, {}};
  const Measurements measured = noisy_lines(body, metal, generator);
  const Identification found = identify(body, measured, {});
  ASSERT_LT(found.chi_squared, largest_by_chance(found.freedom) * found.freedom);

  const TurnedMaterial best = found.material;
  const ElasticConstants constants = elastic_constants(best);
  const FrequencyModel model = body.lowest(best, lines_read);
  LinePairs pairs;
  for (std::size_t line = 0; line < measured.lines.size(); ++line) {
    pairs.emplace_back(line, line);
  }
  const VectorXd expected = unknowns(constants, body.material());
  const VectorXd deviations = Eigen::Vector2d(expected_deviation(constants[0]), expected_deviation(constants[1]));
  const auto density = [&](const VectorXd& point) {
    const TurnedMaterial material = with_unknowns(constants, best, point);
    const VectorXd residuals = line_residuals({measured.lines, model, constants}, pairs, material);
    return -(residuals.squaredNorm() + (point - expected).cwiseQuotient(deviations).squaredNorm()) / 2;
  };
  const std::vector<VectorXd> points = sample(density, unknowns(constants, best), Eigen::Vector2d(1e-3, 1e-3), 5000);
  for (std::size_t k = 0; k < constants.size(); ++k) {
    std::vector<double> values;
    for (const VectorXd& point : points) {
      TurnedMaterial material = with_unknowns(constants, best, point);
      values.push_back(constants[k].in(material));
    }
    const double sampled = half_width_of(std::move(values));
    std::printf("%s: half-width %.4g, of the sample %.4g\n", constants[k].name.c_str(), found.constants[k].half_width,
                sampled);
    EXPECT_NEAR(found.constants[k].half_width / sampled, 1, 0.05) << constants[k].name;
  }
}

}  // namespace
}  // namespace idiophone::fitting
