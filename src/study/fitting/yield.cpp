#include "idiophone/study/fitting/yield.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <iterator>

#include "idiophone/foundation/random_numbers.hpp"
#include "tracked_modes.hpp"

namespace idiophone::fitting {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int bodies = 100'000;  // drawn; the share is then known within 0.2 %

/// Errors of the modes over numbers in standard deviations from their means: a parabola for each number.
struct ErrorModel {
  VectorXd mean;      ///< [modes] cents
  MatrixXd slopes;    ///< [modes x scatters] cents
  MatrixXd bendings;  ///< [modes x scatters] second derivatives, cents

  [[nodiscard]] VectorXd at(const VectorXd& numbers) const {
    return mean + slopes * numbers + 0.5 * bendings * numbers.cwiseAbs2();
  }
};

/// Solves for bodies, and counts them.
class Solver {
 public:
  Solver(const SceneOf& scene_of, const std::vector<Scatter>& scatters, const Target& target,
         const YieldOptions& options)
      : scene_of_(scene_of), scatters_(scatters), target_(target), options_(options) {}

  /// @return none if the watch ended the work
  std::optional<ErrorModel> run() {
    TrackedModes mean{.numbers = options_.modes, .modes = {}, .body = shapes_at(VectorXd::Zero(count()))};
    std::ranges::transform(options_.modes, std::back_inserter(mean.modes), [](int number) { return number - 1; });
    const VectorXd here = errors_of(mean);
    ErrorModel model{here, MatrixXd(here.size(), count()), MatrixXd(here.size(), count())};
    for (Eigen::Index i = 0; i < count(); ++i) {
      const VectorXd beside = VectorXd::Unit(count(), i);
      if (!goes_on()) {
        return {};
      }
      const VectorXd above = errors_of(follow(mean, shapes_at(beside)));
      if (!goes_on()) {
        return {};
      }
      const VectorXd below = errors_of(follow(mean, shapes_at(-beside)));
      model.slopes.col(i) = (above - below) / 2;
      model.bendings.col(i) = above + below - 2 * here;
    }
    return model;
  }

 private:
  [[nodiscard]] Eigen::Index count() const { return static_cast<Eigen::Index>(scatters_.size()); }

  /// @param numbers  in standard deviations from the means
  ModeShapes shapes_at(const VectorXd& numbers) {
    ++solves_;
    std::vector<double> values;
    for (std::size_t i = 0; i < scatters_.size(); ++i) {
      values.push_back(scatters_[i].mean + numbers[static_cast<Eigen::Index>(i)] * scatters_[i].deviation);
    }
    return shapes_up_to(std::ranges::max(options_.modes), body_of(scene_of_(values), options_.body), options_.mass);
  }

  [[nodiscard]] VectorXd errors_of(const TrackedModes& tracked) const {
    return errors(target_, cents_above(target_, tracked));
  }

  [[nodiscard]] bool goes_on() const {
    return !options_.watch || options_.watch({solves_, 1 + 2 * static_cast<int>(scatters_.size()), "yield"});
  }

  const SceneOf& scene_of_;
  const std::vector<Scatter>& scatters_;
  const Target& target_;
  const YieldOptions& options_;
  int solves_ = 0;
};

Yield draw(const ErrorModel& model, double within) {
  NormalNumbers normal;
  VectorXd numbers(model.slopes.cols());
  VectorXd sums = VectorXd::Zero(model.mean.size());
  VectorXd squares = sums;
  int in_tune = 0;
  for (int body = 0; body < bodies; ++body) {
    std::ranges::generate(numbers, [&] { return normal.next(); });
    const VectorXd errors = model.at(numbers);
    in_tune += errors.lpNorm<Eigen::Infinity>() <= within ? 1 : 0;
    sums += errors - model.mean;
    squares += (errors - model.mean).cwiseAbs2();
  }
  Yield yield{.share = static_cast<double>(in_tune) / bodies};
  for (Eigen::Index mode = 0; mode < sums.size(); ++mode) {
    yield.deviations.push_back(std::sqrt(squares[mode] / bodies - std::pow(sums[mode] / bodies, 2)));
    const VectorXd effects = model.slopes.row(mode);
    yield.effects.emplace_back(effects.begin(), effects.end());
  }
  return yield;
}

}  // namespace

std::optional<Yield> yield_of(const SceneOf& scene_of, const std::vector<Scatter>& scatters, const Target& target,
                              const YieldOptions& options) {
  const std::optional<ErrorModel> model = Solver(scene_of, scatters, target, options).run();
  return model ? std::optional(draw(*model, options.within)) : std::nullopt;
}

}  // namespace idiophone::fitting
