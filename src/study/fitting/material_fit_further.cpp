// Which further lines would determine the constants that the measured ones do not.

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "further_sizes.hpp"
#include "material_fit.hpp"

namespace idiophone::fitting {

namespace {

/// What the lines say, and one more.
Evidence with_line(const Evidence& evidence, const Evidence& others, Eigen::Index line) {
  const Eigen::Index lines = evidence.slopes.rows();
  Evidence more = evidence;
  more.residuals.conservativeResizeLike(Eigen::VectorXd::Zero(lines + 1));
  more.mesh_errors.conservativeResizeLike(Eigen::VectorXd::Zero(lines + 1));
  more.slopes.conservativeResize(lines + 1, Eigen::NoChange);
  more.slopes.row(lines) = others.slopes.row(line);
  more.mesh_errors[lines] = others.mesh_errors[line];
  return more;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

}  // namespace

/// Takes the line that narrows the interval of a constant most, until the constant would be determined. Lines that were
/// taken for one constant count for those after it.
void MaterialFit::look_further(Identification& result) {
  constexpr int most_lines = 3;       // of a constant
  constexpr double worthwhile = 0.8;  // of the interval before; a line that leaves more of it says little
  const Eigen::VectorXd held = held_constants();
  if (held.sum() == 0) {
    return;
  }
  FurtherModes modes = further_modes();
  const Eigen::MatrixXd of_values = value_slopes(constants_, material_);
  result.looked_up_to = modes.frequencies[modes.frequencies.size() - 1];
  Evidence known = evidence();
  const ResidualSpread residuals = residual_spread(known, expected_);
  for (Eigen::Index k = 0; k < held.size(); ++k) {
    if (held[k] == 0) {
      continue;
    }
    const Eigen::RowVectorXd constant = Eigen::RowVectorXd::Unit(held.size(), k);
    double width = half_widths(known, residuals, expected_, constant)[0];
    for (int lines = 0; lines < most_lines && width > undetermined; ++lines) {
      const auto [mode, narrowed] = narrowest(modes, known, residuals, constant);
      if (narrowed > worthwhile * width) {
        break;
      }
      width = narrowed;
      modes.is_measured[static_cast<std::size_t>(mode)] = true;
      known = with_line(known, modes.lines, mode);
      result.further.push_back(
          further_line(modes, mode, k, half_widths(known, residuals, expected_, of_values.row(k))[0]));
    }
    is_promised_[static_cast<std::size_t>(k)] = width <= undetermined;
  }
  constexpr int least_modes = 10, most_modes = 20;  // of a size
  Eigen::VectorXd left = half_widths(known, residuals, expected_, Eigen::MatrixXd::Identity(held.size(), held.size()));
  for (Eigen::Index k = 0; k < held.size(); ++k) {
    left[k] = is_promised_[static_cast<std::size_t>(k)] ? 0.0 : held[k] * left[k];
  }
  FurtherSizes sizes = further_sizes({body_, material_, constants_, expected_, residuals, usual_uncertainty(),
                                      std::clamp(static_cast<int>(measured_.size()), least_modes, most_modes)},
                                     left, [this](int solves) { note_solves(solves); });
  result.sizes = std::move(sizes.named);
  result.refused_sizes = std::move(sizes.refused);
}

/// 1 for each constant that may change and is not determined, else 0. [constants]
Eigen::VectorXd MaterialFit::held_constants() const {
  Eigen::VectorXd held = (stages_.back().array() != 0).rowwise().any().cast<double>();
  for (std::size_t k = 0; k < chosen_.size(); ++k) {
    if (chosen_[k] || has_no_effect(constants_[k])) {
      held[static_cast<Eigen::Index>(k)] = 0;
    }
  }
  return held;
}

/// The median of those of the fitted lines that have a mode, cents.
double MaterialFit::usual_uncertainty() const {
  std::vector<double> uncertainties;
  std::ranges::transform(pairs_, std::back_inserter(uncertainties),
                         [this](const auto& pair) { return lines_[pair.first].uncertainty; });
  return median(std::move(uncertainties));
}

/// Those of the present model and half as many more, at least 10. Their lines would be as uncertain as the measured
/// ones, but for the mesh.
MaterialFit::FurtherModes MaterialFit::further_modes() {
  constexpr int least = 10;
  const Multiplet& last = model_->multiplets().back();
  const int modes = last.first + last.count;
  const FrequencyModel model = body_.lowest(material_, modes + std::max(least, modes / 2));
  note_solves(1);
  std::vector<bool> is_measured(model.multiplets().size());
  for (const auto& [line, multiplet] : assign(measured_, *model_, material_, options_.tolerance).pairs) {
    const auto same = std::ranges::find(model.multiplets(), model_->multiplets()[multiplet].first, &Multiplet::first);
    if (same != model.multiplets().end()) {
      is_measured[static_cast<std::size_t>(same - model.multiplets().begin())] = true;
    }
  }
  return {model.multiplets(), model.frequencies(material_),
          imagined_lines(model, constants_, material_, usual_uncertainty(), body_.mesh_errors(model)), is_measured};
}

/// The mode whose line leaves the smallest interval of a combination of the unknowns, and its half-width; infinite if
/// all are measured.
std::pair<Eigen::Index, double> MaterialFit::narrowest(const FurtherModes& modes, const Evidence& known,
                                                       const ResidualSpread& residuals,
                                                       const Eigen::RowVectorXd& combination) const {
  std::pair<Eigen::Index, double> best{0, std::numeric_limits<double>::infinity()};
  for (Eigen::Index m = 0; m < modes.frequencies.size(); ++m) {
    if (!modes.is_measured[static_cast<std::size_t>(m)]) {
      const Evidence more = with_line(known, modes.lines, m);
      const double width = half_widths(more, residuals, expected_, combination)[0];
      best = width < best.second ? std::pair{m, width} : best;
    }
  }
  return best;
}

FurtherLine MaterialFit::further_line(const FurtherModes& modes, Eigen::Index mode, Eigen::Index constant,
                                      double half_width) const {
  const Multiplet& multiplet = modes.multiplets[static_cast<std::size_t>(mode)];
  const auto [place, direction] = body_.antinode(multiplet);
  return {.constant = constants_[static_cast<std::size_t>(constant)].name,
          .first_mode = multiplet.first + 1,
          .modes = multiplet.count,
          .frequency = modes.frequencies[mode],
          .half_width = half_width,
          .place = place,
          .direction = direction};
}

}  // namespace idiophone::fitting
