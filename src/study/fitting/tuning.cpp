#include "idiophone/study/fitting/tuning.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

#include "blow_levels.hpp"
#include "halton_point.hpp"
#include "idiophone/foundation/dense/nonlinear_least_squares.hpp"
#include "idiophone/scene/find_body.hpp"
#include "tracked_modes.hpp"
#include "tuning_wishes.hpp"

namespace idiophone::fitting {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double difference_step = 0.01;  // of the bounds' distance, for derivatives
constexpr double finest = 0.05;           // of the tolerance, where the search ends
constexpr double smallest_step = 1e-5;    // of the bounds' distance
constexpr int most_iterations = 40;
constexpr int usual_iterations = 6;
constexpr int starts_of_each = 2;  // variable, beside the deck's

/// The search was told to stop.
struct TuningStopped {};

/// A body that the search has solved.
struct TriedBody {
  VectorXd point;  ///< [variables] 0 to 1 between the bounds
  TrackedModes tracked;
  std::optional<MatrixXd> slopes = {};  ///< of its measures over the unknowns, if they were computed
};

/// The best of several bodies that were accepted.
struct BestBody {
  TriedBody body;
  double error = std::numeric_limits<double>::infinity();  ///< the largest, cents

  /// Of two that are as good, the other if its derivatives are known: it may be the same body.
  void keep_if_better(const TriedBody& other, double error_of_other) {
    if (error_of_other < error || (error_of_other == error && other.slopes)) {
      *this = {other, error_of_other};
    }
  }
};

class Search {
 public:
  Search(const SceneOf& scene_of, const std::vector<Variable>& variables, const Target& target,
         const TuningOptions& options)
      : scene_of_(scene_of), variables_(variables), wishes_(target, options), options_(options) {
    start_.tracked.numbers = wishes_.numbers();
    std::ranges::transform(wishes_.numbers(), std::back_inserter(start_.tracked.modes),
                           [](int number) { return number - 1; });
    start_.point.resize(variables.size());
    std::ranges::transform(variables, start_.point.begin(), [](const Variable& variable) {
      return (variable.start - variable.lower) / (variable.upper - variable.lower);
    });
    start_.tracked.body = mode_shapes_at(start_.point);
    known_ = now_ = start_;
    keep_if_better();
  }

  Tuning run() {
    bool stopped = false;
    try {
      tell();
      search();
      while (further_ < most_further() && !is_tuned()) {
        begun_ = solves_;
        search_from(halton_point(++further_, start_.point.size()));
      }
    } catch (const TuningStopped&) {
      best_ = passed_;
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
    static_cast<void>(dense::minimize(
        [this](const VectorXd& point) { return residuals_at(point); },
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
        known_ = {here, follow(known_.tracked, solve(here))};
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

  /// At the end of a local search.
  void keep_if_better() {
    best_.keep_if_better(known_, largest_error(known_));
    pass();
  }

  /// At each accepted point: a search for the least squares may leave the smallest error.
  void pass() { passed_.keep_if_better(known_, largest_error(known_)); }

  [[nodiscard]] double largest_error(const TriedBody& body) const {
    return wishes_.errors(measures(body)).lpNorm<Eigen::Infinity>();
  }

  [[nodiscard]] bool is_tuned() const { return best_.error <= options_.tolerance; }

  /// Searches from other points than the deck's.
  [[nodiscard]] int most_further() const { return starts_of_each * static_cast<int>(variables_.size()); }

  /// Tells the watch how far the search is.
  void tell() const {
    if (!options_.watch) {
      return;
    }
    const std::vector<double> values = values_at(passed_.body.point);
    std::string text = further_ == 0 ? "" : fmt::format("search {} of at most {}, ", 1 + further_, 1 + most_further());
    text += fmt::format("best so far: {:.2f} cents", passed_.error);
    for (std::size_t i = 0; i < values.size(); ++i) {
      text += fmt::format(", {} {:.6g}", variables_[i].key, values[i]);
    }
    const int in_a_search = usual_iterations * (1 + static_cast<int>(variables_.size()));
    const int later = further_ == 0 ? 0 : (most_further() - further_) * in_a_search;  // the first one is mostly enough
    if (!options_.watch({solves_, std::max(begun_ + in_a_search, solves_) + 1 + later, text})) {
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
    const scene::Scene scene = scene_of_(values_at(point));
    if (!options_.levels.empty()) {
      return sounding_shapes(scene);
    }
    return shapes_up_to(std::ranges::max(wishes_.numbers()), body_of(scene, options_.body), options_.mass,
                        wishes_.up_to());
  }

  /// With the levels of blows. The modes that sound are those to follow, too, where they reach far enough.
  [[nodiscard]] ModeShapes sounding_shapes(const scene::Scene& scene) const {
    const int highest = std::ranges::max(wishes_.numbers());
    const scene::Solids alone = body_of(scene, options_.body);  // refuses joints: the modes below are those of one mesh
    std::vector<std::string> listeners;
    std::ranges::transform(options_.levels, std::back_inserter(listeners), &WantedLevel::listener);
    sound_maps::SolvedSolid solved =
        sound_maps::solve_solid(scene, scene::find_body(scene.bodies, options_.body),
                                {.up_to = scene.audio.max_frequency, .mass = options_.mass});
    ModeShapes shapes = shapes_of(solved.meshes.front(), solved.found.modes);
    if (!are_enough(shapes, highest, wishes_.up_to())) {
      shapes = shapes_up_to(highest, alone, options_.mass, wishes_.up_to());
    }
    shapes.levels = blow_levels(scene, options_.body, listeners, std::move(solved));
    return shapes;
  }

  /// Of the best body, cents; NaN if the user does not want to wait. [its modes up to the highest tuned one]
  [[nodiscard]] std::vector<double> mesh_errors(bool stopped) const {
    const int count = std::ranges::max(best_.body.tracked.modes) + 1;
    if (stopped) {
      return std::vector<double>(count, std::numeric_limits<double>::quiet_NaN());
    }
    return mesh_errors_of(body_of(scene_of_(values_at(best_.body.point)), options_.body),
                          {.count = count, .mass = options_.mass});
  }

  std::optional<VectorXd> residuals_at(const VectorXd& point) {
    try {
      now_ = point == known_.point ? known_ : TriedBody{point, follow(known_.tracked, solve(point))};
    } catch (const std::runtime_error& refused) {  // no such shape, or no such mode
      refusal_ = refused.what();
      return {};
    }
    return VectorXd(wishes_.residuals(measures(now_)));
  }

  [[nodiscard]] VectorXd measures(const TriedBody& body) const { return wishes_.measures(body.tracked); }

  MatrixXd residual_slopes(const VectorXd& point) {
    if (now_.point != point) {
      throw std::logic_error("derivatives are wanted elsewhere than at the last accepted point");
    }
    known_ = now_;
    pass();
    const VectorXd here = measures(known_);
    MatrixXd slopes(here.size(), point.size());
    for (Eigen::Index i = 0; i < point.size(); ++i) {
      const double change = point[i] > 0.5 ? -difference_step : difference_step;
      const VectorXd beside = point + change * VectorXd::Unit(point.size(), i);
      slopes.col(i) = (measures({beside, follow(known_.tracked, solve(beside))}) - here) / change;
    }
    known_.slopes = slopes;
    pass();
    return wishes_.residuals(slopes);
  }

  [[nodiscard]] std::vector<Bound> bounds_at(const VectorXd& point) const {
    constexpr double touching = 1e-6;
    std::vector<Bound> bounds;
    std::ranges::transform(point, std::back_inserter(bounds), [](double place) {
      return place < touching ? Bound::lower : place > 1 - touching ? Bound::upper : Bound::none;
    });
    return bounds;
  }

  /// Derivatives of the best body's measures by the variables, in their own units; NaN if they are not known.
  [[nodiscard]] MatrixXd own_slopes() const {
    const MatrixXd unknown = MatrixXd::Constant(measures(best_.body).size(), best_.body.point.size(),
                                                std::numeric_limits<double>::quiet_NaN());
    MatrixXd slopes = best_.body.slopes.value_or(unknown);
    for (Eigen::Index v = 0; v < slopes.cols(); ++v) {
      const Variable& variable = variables_[static_cast<std::size_t>(v)];
      slopes.col(v) /= variable.upper - variable.lower;
    }
    return slopes;
  }

  [[nodiscard]] Tuning result_of(bool stopped) const {
    Tuning result{.values = values_at(best_.body.point),
                  .bounds = bounds_at(best_.body.point),
                  .refusal = refusal_,
                  .solves = solves_,
                  .stopped = stopped};
    const VectorXd errors = wishes_.errors(measures(best_.body));
    const MatrixXd slopes = own_slopes();
    const TrackedModes &start = start_.tracked, &best = best_.body.tracked;
    const MatrixXd likeness = similarities(start.body, start.modes, best.body);
    const std::vector<double> mesh_errors = this->mesh_errors(stopped);
    const std::vector<std::string> kinds = kinds_of(best.body);
    for (std::size_t i = 0; i < options_.modes.size(); ++i) {
      const double frequency = best.body.frequencies[best.modes[i]];
      result.modes.push_back({.start_mode = options_.modes[i],
                              .mode = best.modes[i] + 1,
                              .start = start.body.frequencies[start.modes[i]],
                              .frequency = frequency,
                              .wanted = frequency * std::exp2(-errors[i] / 1200),
                              .cents = errors[i],
                              .similarity = likeness(i, best.modes[i]),
                              .mesh_error = mesh_errors[best.modes[i]],
                              .kind = kinds[best.modes[i]]});
      const VectorXd row = slopes.row(static_cast<Eigen::Index>(i));
      result.sensitivities.emplace_back(row.begin(), row.end());
    }
    result.decays = wishes_.decays(start, best, slopes);
    result.levels = wishes_.levels(start.body, best.body, slopes);
    result.avoided = wishes_.avoided(best.body);
    result.is_tuned = is_tuned();
    return result;
  }

  const SceneOf& scene_of_;
  const std::vector<Variable>& variables_;
  Wishes wishes_;
  const TuningOptions& options_;
  int solves_ = 0;
  int further_ = 0;  ///< searches from other points that have begun
  int begun_ = 0;    ///< solves before the present search
  std::string refusal_;
  TriedBody start_, known_, now_;  ///< known: the last accepted; now: the last tried
  BestBody best_;                  ///< of the ends of the local searches
  BestBody passed_;                ///< of all accepted ones
};

}  // namespace

Tuning tune(const SceneOf& scene_of, const std::vector<Variable>& variables, const Target& target,
            const TuningOptions& options) {
  return Search(scene_of, variables, target, options).run();
}

}  // namespace idiophone::fitting
