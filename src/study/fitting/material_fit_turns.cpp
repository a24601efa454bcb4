// What the lines say of the turns of a material's axes.

#include <algorithm>
#include <cmath>

#include "axis_symmetries.hpp"
#include "idiophone/study/partials/compare.hpp"
#include "material_fit.hpp"

namespace idiophone::fitting {

bool MaterialFit::has_turns() const {
  return std::ranges::find(constants_, ConstantKind::turn, &ElasticConstant::kind) != constants_.end();
}

bool MaterialFit::has_no_effect(const ElasticConstant& constant) const {
  return constant.kind == ConstantKind::turn && is_round_about(constant.name.back() - 'x', material_);
}

/// Where axes lie along planes of symmetry of the body, lines change with the square of a turn, and their derivatives
/// are zero. So the slopes by a turn are secants over its own interval to the side on which that is wider, unless it is
/// so narrow that the derivatives will do.
Evidence MaterialFit::over_turns(Evidence known) const {
  constexpr double narrow = 0.01, widest = 0.64;  // rad
  constexpr int halvings = 4;
  const ResidualSpread residuals = residual_spread(known, expected_);
  for (std::size_t turn = 0; turn < constants_.size(); ++turn) {
    const auto k = static_cast<Eigen::Index>(turn);
    const Eigen::RowVectorXd unknown = Eigen::RowVectorXd::Unit(known.slopes.cols(), k);
    if (constants_[turn].kind != ConstantKind::turn || half_widths(known, residuals, expected_, unknown)[0] < narrow) {
      continue;
    }
    const auto holds = [&](double change) {
      known.slopes.col(k) = secant(k, change);
      return half_widths(known, residuals, expected_, unknown)[0] <= std::abs(change);
    };
    double wider = 0.0;
    for (const double side : {-1.0, 1.0}) {
      double above = narrow;
      while (above < widest && !holds(side * above)) {
        above *= 2;
      }
      double below = above / 2;
      for (int halving = 0; halving < halvings; ++halving) {
        const double middle = (below + above) / 2;
        (holds(side * middle) ? above : below) = middle;
      }
      wider = above > std::abs(wider) ? side * above : wider;
    }
    known.slopes.col(k) = secant(k, wider);
  }
  return known;
}

/// The change of the lines' distances from their modes, over their uncertainties, per rad. [pairs]
Eigen::VectorXd MaterialFit::secant(Eigen::Index turn, double change) const {
  const Eigen::VectorXd here = unknowns(constants_, material_);
  const Eigen::VectorXd there = here + change * Eigen::VectorXd::Unit(here.size(), turn);
  const Eigen::VectorXd now = body_.frequencies_nearby(material_);
  const Eigen::VectorXd then = body_.frequencies_nearby(with_unknowns(constants_, material_, there));
  Eigen::VectorXd slopes(static_cast<Eigen::Index>(pairs_.size()));
  std::ranges::transform(pairs_, slopes.begin(), [&](const auto& pair) {
    const Multiplet& modes = model_->multiplets()[pair.second];
    const double cents =
        partials::cents(then.segment(modes.first, modes.count).mean(), now.segment(modes.first, modes.count).mean());
    return -cents / change / lines_[pair.first].uncertainty;
  });
  return slopes;
}

/// Other turns by which the lines fit as well, because a body brought into itself by a rotation sounds the same when
/// only its material is rotated. Of those that the symmetry of the material makes equal, the smallest one counts.
void MaterialFit::look_for_equivalents(Identification& result) {
  if (!has_turns()) {
    return;
  }
  const std::vector<Eigen::Matrix3d> of_material = symmetries_of(material_);
  const Eigen::Matrix3d axes = body_.axes();
  const auto turned = [&](const Eigen::Matrix3d& rotation) {
    return with_turns(turns_of(smallest_turn(axes.transpose() * rotation * axes * material_.turn(), of_material)));
  };
  material_ = turned(Eigen::Matrix3d::Identity()).value_or(material_);
  std::vector<TurnedMaterial> known = {material_};
  for (const Eigen::Matrix3d& rotation : symmetries_of_box(body_.directions(), body_.extents())) {
    const std::optional<TurnedMaterial> other = turned(rotation);
    const auto is_near = [&](const TurnedMaterial& one) { return are_within_intervals(one, *other); };
    if (other && std::ranges::none_of(known, is_near) && fits_as_well(*other)) {
      known.push_back(*other);
      result.equivalent_turns.push_back(other->turns);
    }
  }
}

/// The material with other turns; those without effect stay. None where a turn would change that may not.
std::optional<TurnedMaterial> MaterialFit::with_turns(const Vector3& turns) const {
  constexpr double negligible = 1e-6;  // degrees
  TurnedMaterial other = material_;
  other.turns.setZero();
  TurnedMaterial wanted = material_;
  wanted.turns = turns;
  for (const ElasticConstant& constant : constants_) {
    if (constant.kind == ConstantKind::turn) {
      TurnedMaterial present = material_;
      constant.in(other) = constant.in(has_no_effect(constant) ? present : wanted);
      constant.in(wanted) = constant.in(other);
    }
  }
  return (wanted.turns - other.turns).lpNorm<Eigen::Infinity>() < negligible ? std::optional(other) : std::nullopt;
}

/// Whether the intervals of the turns are wider than the difference.
bool MaterialFit::are_within_intervals(const TurnedMaterial& a, const TurnedMaterial& b) const {
  const Eigen::VectorXd difference =
      (value_slopes(constants_, material_) * (unknowns(constants_, a) - unknowns(constants_, b))).cwiseAbs();
  return (difference.array() <= widths_.array()).all();
}

/// Solves with another material. @return whether the lines are no farther away than by chance
bool MaterialFit::fits_as_well(const TurnedMaterial& material) {
  const double allowed = line_residuals(problem(), pairs_, material_).squaredNorm() + largest_by_chance(1);
  const FrequencyModel model = body_.model(material, model_up_to());
  note_solves(1);
  const FitProblem other{lines_, model, constants_};
  const LinePairs pairs = assign(lines_, model, material, options_.tolerance).pairs;
  return pairs.size() == pairs_.size() && line_residuals(other, pairs, material).squaredNorm() <= allowed;
}

}  // namespace idiophone::fitting
