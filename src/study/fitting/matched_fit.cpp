#include "matched_fit.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "idiophone/foundation/dense/nonlinear_least_squares.hpp"
#include "idiophone/study/partials/compare.hpp"

namespace idiophone::fitting {

Eigen::VectorXd line_residuals(const FitProblem& problem, const LinePairs& pairs, const TurnedMaterial& material) {
  const Eigen::VectorXd frequencies = problem.model.frequencies(material);
  Eigen::VectorXd values(static_cast<Eigen::Index>(pairs.size()));
  std::ranges::transform(pairs, values.begin(), [&](const auto& pair) {
    const Line& line = problem.lines[pair.first];
    return partials::cents(line.frequency, frequencies[static_cast<Eigen::Index>(pair.second)]) / line.uncertainty;
  });
  return values;
}

Eigen::MatrixXd line_slopes(const FitProblem& problem, const LinePairs& pairs, const TurnedMaterial& material) {
  const Eigen::MatrixXd slopes = problem.model.cents_slopes(problem.constants, material);
  Eigen::MatrixXd values(static_cast<Eigen::Index>(pairs.size()), slopes.cols());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto& [line, multiplet] = pairs[i];
    values.row(static_cast<Eigen::Index>(i)) =
        -slopes.row(static_cast<Eigen::Index>(multiplet)) / problem.lines[line].uncertainty;
  }
  return values;
}

TurnedMaterial fit_pairs(const FitProblem& problem, const LinePairs& pairs, const TurnedMaterial& start,
                         const FitRules& rules) {
  if (rules.ties.cols() == 0) {
    return start;
  }
  const Eigen::VectorXd origin = unknowns(problem.constants, start);
  const Expectation* expected = rules.expected;
  const auto material_at = [&](const Eigen::VectorXd& moves) {
    return with_unknowns(problem.constants, start, origin + rules.ties * moves);
  };
  const auto residuals = [&](const Eigen::VectorXd& moves) -> std::optional<Eigen::VectorXd> {
    const TurnedMaterial material = material_at(moves);
    if (!is_stable(material)) {
      return {};
    }
    const Eigen::VectorXd of_lines = line_residuals(problem, pairs, material);
    if (expected == nullptr) {
      return of_lines;
    }
    Eigen::VectorXd all(of_lines.size() + origin.size());
    all << of_lines, (origin + rules.ties * moves - expected->middle).cwiseQuotient(expected->deviation);
    return all;
  };
  const auto jacobian = [&](const Eigen::VectorXd& moves) -> Eigen::MatrixXd {
    const Eigen::MatrixXd of_lines = line_slopes(problem, pairs, material_at(moves)) * rules.ties;
    if (expected == nullptr) {
      return of_lines;
    }
    Eigen::MatrixXd all(of_lines.rows() + rules.ties.rows(), rules.ties.cols());
    all << of_lines, expected->deviation.cwiseInverse().asDiagonal() * rules.ties;
    return all;
  };
  const Eigen::VectorXd infinite =
      Eigen::VectorXd::Constant(rules.ties.cols(), std::numeric_limits<double>::infinity());
  return material_at(dense::minimize(residuals, jacobian, Eigen::VectorXd::Zero(rules.ties.cols()),
                                     {-infinite, infinite}, {.step = 1e-9})
                         .point);
}

MatchedFit fit_and_match(const FitProblem& problem, const TurnedMaterial& start, const FitRules& rules) {
  MatchedFit fit{.material = start, .pairs = {}};
  constexpr int most_turns = 20;
  for (int turn = 0; turn < most_turns; ++turn) {
    Assignment matched = assign(problem.lines, problem.model, fit.material, rules.tolerance);
    fit.cost = matched.cost;
    if (matched.pairs.empty() || matched.pairs == fit.pairs) {
      fit.pairs = std::move(matched.pairs);
      break;
    }
    fit.pairs = std::move(matched.pairs);
    fit.material = fit_pairs(problem, fit.pairs, fit.material, rules);
  }
  return fit;
}

MatchedFit fit_around(const FitProblem& problem, const TurnedMaterial& start, const FitRules& rules,
                      const std::vector<double>& around) {
  constexpr double clearly = 1e-3;
  const Eigen::VectorXd middle = unknowns(problem.constants, start);
  MatchedFit best = fit_and_match(problem, start, rules);
  for (Eigen::Index unknown = 0; unknown < rules.ties.cols(); ++unknown) {
    for (const double distance : around) {
      for (const double change : {-distance, distance}) {
        const TurnedMaterial other = with_unknowns(problem.constants, start, middle + change * rules.ties.col(unknown));
        if (!is_stable(other)) {
          continue;
        }
        MatchedFit fit = fit_and_match(problem, other, rules);
        const bool is_better = best.pairs.empty() || fit.cost < best.cost - clearly;
        if (!fit.pairs.empty() && is_better) {
          best = std::move(fit);
        }
      }
    }
  }
  return best;
}

}  // namespace idiophone::fitting
