#include "idiophone/study/fitting/tuning.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/scene/find_body.hpp"
#include "idiophone/study/partials/compare.hpp"
#include "least_squares.hpp"
#include "mode_shapes.hpp"

namespace idiophone::fitting {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int more_modes = 8;             // above the highest to tune, as their order may change
constexpr double least_similarity = 0.5;  // of the shapes of one mode on two neighbouring bodies
constexpr double difference_step = 0.01;  // of the bounds' distance, for derivatives
constexpr double finest = 0.05;           // of the tolerance, where the search ends
constexpr double smallest_step = 1e-5;    // of the bounds' distance
constexpr int most_iterations = 40;
constexpr int usual_iterations = 6;
constexpr int starts_of_each = 2;  // variable, beside the deck's

/// The search was told to stop.
struct TuningStopped {};

/// A number of the sequence of van der Corput: evenly spread between 0 and 1.
double van_der_corput(int number, int base) {
  double value = 0.0;
  double place = 1.0;
  for (; number > 0; number /= base) {
    place /= base;
    value += place * (number % base);
  }
  return value;
}

/// A point of Halton's sequence, within the middle nine tenths of each direction.
VectorXd halton_point(int number, Eigen::Index directions) {
  constexpr std::array bases = {2, 3, 5, 7, 11, 13, 17, 19};
  VectorXd point(directions);
  for (Eigen::Index i = 0; i < directions; ++i) {
    point[i] = 0.05 + 0.9 * van_der_corput(number, bases.at(i % bases.size()));
  }
  return point;
}

/// A body, and which of its modes are those to tune.
struct TrackedBody {
  VectorXd point;  ///< [variables] 0 to 1 between the bounds
  ModeShapes body;
  std::vector<int> modes;  ///< from 0 on, in the target's order
};

class Search {
 public:
  Search(const SceneOf& scene_of, const std::vector<Variable>& variables, const Target& target,
         const TuningOptions& options)
      : scene_of_(scene_of), variables_(variables), target_(target), options_(options) {
    std::ranges::transform(options.modes, std::back_inserter(start_.modes), [](int number) { return number - 1; });
    start_.point.resize(variables.size());
    std::ranges::transform(variables, start_.point.begin(), [](const Variable& variable) {
      return (variable.start - variable.lower) / (variable.upper - variable.lower);
    });
    slopes_ = MatrixXd::Zero(static_cast<Eigen::Index>(options.modes.size()), start_.point.size());
    start_.body = mode_shapes_at(start_.point);
    known_ = now_ = start_;
    keep_if_better();
  }

  Tuning run() {
    bool stopped = false;
    try {
      tell();
      search();
      for (int number = 1; number <= starts_of_each * static_cast<int>(variables_.size()) && !is_tuned(); ++number) {
        search_from(halton_point(number, start_.point.size()));
      }
    } catch (const TuningStopped&) {
      keep_if_better();
      stopped = true;
    }
    return result_of(stopped);
  }

 private:
  [[nodiscard]] std::vector<double> values_at(const VectorXd& point) const {
    std::vector<double> values;
    for (std::size_t i = 0; i < variables_.size(); ++i) {
      const Variable& variable = variables_[i];
      values.push_back(variable.lower + point[i] * (variable.upper - variable.lower));
    }
    return values;
  }

  /// A local search from the last accepted point.
  void search() {
    const auto count = static_cast<Eigen::Index>(variables_.size());
    static_cast<void>(
        minimize([this](const VectorXd& point) { return residuals_at(point); },
                 [this](const VectorXd& point) { return residual_slopes(point); }, known_.point,
                 {VectorXd::Zero(count), VectorXd::Ones(count)},
                 {.residual = finest * options_.tolerance, .step = smallest_step, .iterations = most_iterations}));
    keep_if_better();
  }

  /// A local search from another point, if the modes can be followed there.
  void search_from(const VectorXd& point) {
    try {
      if (walk_to(point)) {
        search();
      }
    } catch (const std::runtime_error& refused) {  // a mode is lost next to an accepted point
      refusal_ = refused.what();
      keep_if_better();
    }
  }

  /// Follows the modes from the start to a point, which is then the last accepted one.
  /// @return false where they can't be followed
  bool walk_to(const VectorXd& point) {
    constexpr double smallest_part = 0.1;
    known_ = start_;
    for (double done = 0.0, part = 0.5; done < 1.0;) {
      const double next = std::min(1.0, done + part);
      const VectorXd here = start_.point + next * (point - start_.point);
      try {
        known_ = tracked(here, solve(here), known_);
        done = next;
      } catch (const std::runtime_error&) {  // no such shape, or no such mode
        part /= 2;
        if (part < smallest_part) {
          return false;
        }
      }
    }
    return true;
  }

  void keep_if_better() {
    const double largest = largest_error(known_);
    if (largest < smallest_error_) {
      smallest_error_ = largest;
      best_ = known_;
      best_slopes_ = slopes_;
    }
  }

  [[nodiscard]] double largest_error(const TrackedBody& body) const {
    return residuals(body).lpNorm<Eigen::Infinity>();
  }

  [[nodiscard]] bool is_tuned() const { return smallest_error_ <= options_.tolerance; }

  /// Tells the watch how far the search is.
  void tell() const {
    if (!options_.watch) {
      return;
    }
    const TrackedBody& best = largest_error(known_) < smallest_error_ ? known_ : best_;
    const std::vector<double> values = values_at(best.point);
    std::string text = fmt::format("best so far: {:.2f} cents", std::min(smallest_error_, largest_error(known_)));
    for (std::size_t i = 0; i < values.size(); ++i) {
      text += fmt::format(", {} {:.6g}", variables_[i].key, values[i]);
    }
    const int in_a_search = usual_iterations * (1 + static_cast<int>(variables_.size()));
    if (!options_.watch({solves_, std::max(1 + in_a_search, solves_ + 1), text})) {
      throw TuningStopped();
    }
  }

  ModeShapes solve(const VectorXd& point) {
    ModeShapes shapes = mode_shapes_at(point);
    tell();
    return shapes;
  }

  ModeShapes mode_shapes_at(const VectorXd& point) {
    ++solves_;
    const int count = *std::ranges::max_element(options_.modes) + more_modes;
    const scene::Scene scene = scene_of_(values_at(point));
    return mode_shapes(tuned_body(scene), {.count = count, .mass = options_.mass});
  }

  [[nodiscard]] scene::Solids tuned_body(const scene::Scene& scene) const {
    return scene::Solids(scene).alone(scene::find_body(scene.bodies, options_.body));
  }

  /// Of the best body, cents; NaN if the user does not want to wait. [its modes up to the highest tuned one]
  [[nodiscard]] std::vector<double> mesh_errors(bool stopped) const {
    const int count = *std::ranges::max_element(best_.modes) + 1;
    if (stopped) {
      return std::vector<double>(count, std::numeric_limits<double>::quiet_NaN());
    }
    const scene::Scene scene = scene_of_(values_at(best_.point));
    return mesh_errors_of(tuned_body(scene), {.count = count, .mass = options_.mass});
  }

  /// Recognises the modes by the shapes of `known`.
  /// @throws std::runtime_error where one of them is no longer there
  [[nodiscard]] TrackedBody tracked(const VectorXd& point, ModeShapes body, const TrackedBody& known) const {
    MatrixXd likeness = similarities(known.body, known.modes, body);
    TrackedBody found{point, std::move(body), std::vector<int>(known.modes.size())};
    for (std::size_t i = 0; i < known.modes.size(); ++i) {
      Eigen::Index which = 0;
      Eigen::Index mode = 0;
      const double best = likeness.maxCoeff(&which, &mode);
      if (best < least_similarity) {
        throw std::runtime_error(
            fmt::format("mode {} of the start can't be recognised: the most similar shape has a modal assurance "
                        "criterion of {:.2f}; choose narrower bounds",
                        options_.modes[i], best));
      }
      found.modes[which] = static_cast<int>(mode);
      likeness.row(which).setConstant(-1.0);
      likeness.col(mode).setConstant(-1.0);
    }
    return found;
  }

  std::optional<VectorXd> residuals_at(const VectorXd& point) {
    try {
      now_ = point == known_.point ? known_ : tracked(point, solve(point), known_);
    } catch (const std::runtime_error& refused) {  // no such shape, or no such mode
      refusal_ = refused.what();
      return {};
    }
    return residuals(now_);
  }

  /// Cents of each mode above the target; of ratios those above the first one's.
  [[nodiscard]] VectorXd residuals(const TrackedBody& body) const {
    const VectorXd all = cents(body);
    return target_.are_ratios ? VectorXd((all.array() - all[0]).tail(all.size() - 1)) : all;
  }

  /// Cents of each mode above the target's value.
  [[nodiscard]] VectorXd cents(const TrackedBody& body) const {
    VectorXd all(body.modes.size());
    for (std::size_t i = 0; i < body.modes.size(); ++i) {
      all[i] = partials::cents(body.body.frequencies[body.modes[i]], target_.values[i]);
    }
    return all;
  }

  MatrixXd residual_slopes(const VectorXd& point) {
    if (now_.point != point) {
      throw std::logic_error("derivatives are wanted elsewhere than at the last accepted point");
    }
    known_ = now_;
    const VectorXd here = cents(known_);
    slopes_.resize(here.size(), point.size());
    for (Eigen::Index i = 0; i < point.size(); ++i) {
      const double change = point[i] > 0.5 ? -difference_step : difference_step;
      const VectorXd beside = point + change * VectorXd::Unit(point.size(), i);
      slopes_.col(i) = (cents(tracked(beside, solve(beside), known_)) - here) / change;
    }
    return target_.are_ratios ? MatrixXd((slopes_.rowwise() - slopes_.row(0)).bottomRows(here.size() - 1)) : slopes_;
  }

  [[nodiscard]] std::vector<Bound> bounds_at(const VectorXd& point) const {
    constexpr double touching = 1e-6;
    std::vector<Bound> bounds;
    std::ranges::transform(point, std::back_inserter(bounds), [](double place) {
      return place < touching ? Bound::lower : place > 1 - touching ? Bound::upper : Bound::none;
    });
    return bounds;
  }

  [[nodiscard]] Tuning result_of(bool stopped) const {
    Tuning result{.values = values_at(best_.point),
                  .bounds = bounds_at(best_.point),
                  .refusal = refusal_,
                  .solves = solves_,
                  .stopped = stopped};
    const VectorXd all = cents(best_);
    const VectorXd errors = target_.are_ratios ? VectorXd(all.array() - all[0]) : all;
    const MatrixXd likeness = similarities(start_.body, start_.modes, best_.body);
    const std::vector<double> mesh_errors = this->mesh_errors(stopped);
    for (std::size_t i = 0; i < best_.modes.size(); ++i) {
      const double frequency = best_.body.frequencies[best_.modes[i]];
      result.modes.push_back({.start_mode = options_.modes[i],
                              .mode = best_.modes[i] + 1,
                              .start = start_.body.frequencies[start_.modes[i]],
                              .frequency = frequency,
                              .wanted = frequency * std::exp2(-errors[i] / 1200),
                              .cents = errors[i],
                              .similarity = likeness(i, best_.modes[i]),
                              .mesh_error = mesh_errors[best_.modes[i]]});
      auto& row = result.sensitivities.emplace_back();
      for (std::size_t v = 0; v < variables_.size(); ++v) {
        row.push_back(best_slopes_(i, v) / (variables_[v].upper - variables_[v].lower));
      }
    }
    result.is_tuned = is_tuned();
    return result;
  }

  const SceneOf& scene_of_;
  const std::vector<Variable>& variables_;
  const Target& target_;
  const TuningOptions& options_;
  int solves_ = 0;
  std::string refusal_;
  TrackedBody start_, known_, now_, best_;  ///< known: the last accepted; now: the last tried
  MatrixXd slopes_, best_slopes_;  ///< cents of each mode over the unknowns, at the last accepted point, the best
  double smallest_error_ = std::numeric_limits<double>::infinity();  ///< the largest of the best body's, cents
};

}  // namespace

Tuning tune(const SceneOf& scene_of, const std::vector<Variable>& variables, const Target& target,
            const TuningOptions& options) {
  return Search(scene_of, variables, target, options).run();
}

}  // namespace idiophone::fitting
