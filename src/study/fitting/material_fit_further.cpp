// Which further lines would determine the constants that the measured ones do not.

#include <algorithm>
#include <cmath>
#include <limits>

#include "material_fit.hpp"

namespace idiophone::fitting {

namespace {

/// What the lines say, and one more where its mode is.
/// @param slopes, mesh_error  as Evidence has them
Evidence with_line(const Evidence& evidence, const Eigen::RowVectorXd& slopes, double mesh_error) {
  const Eigen::Index lines = evidence.slopes.rows();
  Evidence more = evidence;
  more.residuals.conservativeResizeLike(Eigen::VectorXd::Zero(lines + 1));
  more.mesh_errors.conservativeResizeLike(Eigen::VectorXd::Zero(lines + 1));
  more.slopes.conservativeResize(lines + 1, Eigen::NoChange);
  more.slopes.row(lines) = slopes;
  more.mesh_errors[lines] = mesh_error;
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
      known = with_line(known, modes.slopes.row(mode), modes.mesh_errors[mode]);
      result.further.push_back(
          further_line(modes, mode, k, half_widths(known, residuals, expected_, of_values.row(k))[0]));
    }
    is_promised_[static_cast<std::size_t>(k)] = width <= undetermined;
  }
}

/// 1 for each constant that may change and is not determined, else 0. [constants]
Eigen::VectorXd MaterialFit::held_constants() const {
  Eigen::VectorXd held = (stages_.back().array() != 0).rowwise().any().cast<double>();
  for (std::size_t k = 0; k < chosen_.size(); ++k) {
    if (chosen_[k]) {
      held[static_cast<Eigen::Index>(k)] = 0;
    }
  }
  return held;
}

/// Those of the present model and half as many more, at least 10. Their lines would be as uncertain as the measured
/// ones, but for the mesh.
MaterialFit::FurtherModes MaterialFit::further_modes() {
  constexpr int least = 10;
  const Multiplet& last = model_->multiplets().back();
  const int modes = last.first + last.count;
  const FrequencyModel model = body_.lowest(material_, modes + std::max(least, modes / 2));
  note_solve();
  std::vector<bool> is_measured(model.multiplets().size());
  std::vector<double> uncertainties;
  for (const auto& [line, multiplet] : assign(measured_, *model_, material_, options_.tolerance).pairs) {
    uncertainties.push_back(measured_[line].uncertainty);
    const auto same = std::ranges::find(model.multiplets(), model_->multiplets()[multiplet].first, &Multiplet::first);
    if (same != model.multiplets().end()) {
      is_measured[static_cast<std::size_t>(same - model.multiplets().begin())] = true;
    }
  }
  const std::vector<double> estimates = body_.mesh_errors(model);
  const Eigen::Map<const Eigen::ArrayXd> errors(estimates.data(), static_cast<Eigen::Index>(estimates.size()));
  const Eigen::ArrayXd uncertainty = (std::pow(median(uncertainties), 2) + errors.square()).sqrt();
  return {model.multiplets(), model.frequencies(material_),
          uncertainty.inverse().matrix().asDiagonal() * model.cents_slopes(constants_, material_), errors / uncertainty,
          is_measured};
}

/// The mode whose line leaves the smallest interval of a combination of the unknowns, and its half-width; infinite if
/// all are measured.
std::pair<Eigen::Index, double> MaterialFit::narrowest(const FurtherModes& modes, const Evidence& known,
                                                       const ResidualSpread& residuals,
                                                       const Eigen::RowVectorXd& combination) const {
  std::pair<Eigen::Index, double> best{0, std::numeric_limits<double>::infinity()};
  for (Eigen::Index m = 0; m < modes.slopes.rows(); ++m) {
    if (!modes.is_measured[static_cast<std::size_t>(m)]) {
      const Evidence more = with_line(known, modes.slopes.row(m), modes.mesh_errors[m]);
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
