#include "fit_directional_loss.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "confidence.hpp"
#include "idiophone/foundation/dense/nonlinear_least_squares.hpp"
#include "idiophone/solids/solid/directional_loss.hpp"

namespace idiophone::fitting {

namespace {

/// Which unknown is the loss factor of E_x, E_y, E_z, G_xy, G_yz and G_xz. The first unknown is that which several
/// share.
using Places = std::array<Eigen::Index, 6>;

struct Fit {
  Places places{};
  Eigen::VectorXd logarithms;  ///< [unknowns] of the loss factors
  double squares = 0.0;        ///< of the relative errors of the rates

  [[nodiscard]] Eigen::Index unknowns() const { return logarithms.size(); }
};

scene::LossFactor loss_of(const Places& places, const Eigen::VectorXd& logarithms) {
  const auto value = [&](std::size_t direction) { return std::exp(logarithms[places.at(direction)]); };
  scene::LossFactor loss;
  loss.value = std::exp(logarithms.maxCoeff());
  loss.directions = {{value(0), value(1), value(2)}, {value(3), value(4), value(5)}};
  return loss;
}

class DirectionalDecays {
 public:
  DirectionalDecays(const scene::Material& material, const Eigen::Matrix3d& axes,
                    const std::vector<StrainedDecay>& decays)
      : oriented_{.material = material, .axes = axes},
        stiffness_(solid::stiffness_matrix(solid::elasticity(material, axes))),
        decays_(decays) {}

  /// Relative errors of the rates, [decays].
  [[nodiscard]] Eigen::VectorXd errors(const Places& places, const Eigen::VectorXd& logarithms) const {
    solid::OrientedMaterial oriented = oriented_;
    oriented.material.damping.loss = loss_of(places, logarithms);
    const solid::StiffnessMatrix relaxing = stiffness_matrix(solid::relaxing_elasticity(oriented));
    Eigen::VectorXd result(decays_.size());
    std::ranges::transform(decays_, result.begin(), [&](const StrainedDecay& each) {
      const double part = relaxing.cwiseProduct(each.strain).sum() / stiffness_.cwiseProduct(each.strain).sum();
      const double rate = oriented.material.damping.loss->value * part * std::numbers::pi * each.decay.frequency;
      return rate * each.decay.decay_time / std::log(1000.0) - 1;
    });
    return result;
  }

  /// The best loss factors where some have places of their own.
  [[nodiscard]] Fit best(const Places& places, const Eigen::VectorXd& start) const {
    const dense::Residuals residuals = [&](const Eigen::VectorXd& point) {
      return std::optional(errors(places, point));
    };
    const dense::Jacobian jacobian = [&](const Eigen::VectorXd& point) {
      constexpr double h = 1e-5;
      Eigen::MatrixXd slopes(decays_.size(), point.size());
      for (Eigen::Index k = 0; k < point.size(); ++k) {
        const Eigen::VectorXd change = h * Eigen::VectorXd::Unit(point.size(), k);
        slopes.col(k) = (errors(places, point + change) - errors(places, point - change)) / (2 * h);
      }
      return slopes;
    };
    const dense::Box box{.lower = Eigen::VectorXd::Constant(start.size(), std::log(1e-6)),
                         .upper = Eigen::VectorXd::Constant(start.size(), std::log(0.3))};
    const dense::LeastSquares found =
        dense::minimize(residuals, jacobian, start.cwiseMax(box.lower).cwiseMin(box.upper), box, {.step = 1e-6});
    return {places, found.point, found.residuals.squaredNorm()};
  }

 private:
  solid::OrientedMaterial oriented_;
  solid::StiffnessMatrix stiffness_;
  const std::vector<StrainedDecay>& decays_;
};

/// The best fit in which one more direction has a loss factor of its own. None: all have.
std::optional<Fit> with_one_more(const DirectionalDecays& decays, const Fit& fit) {
  std::optional<Fit> best;
  for (std::size_t d = 0; d < fit.places.size(); ++d) {
    if (fit.places.at(d) != 0) {
      continue;
    }
    Places places = fit.places;
    places.at(d) = fit.unknowns();
    Eigen::VectorXd start(fit.unknowns() + 1);
    start << fit.logarithms, fit.logarithms[0];
    Fit candidate = decays.best(places, start);
    if (!best || candidate.squares < best->squares) {
      best = std::move(candidate);
    }
  }
  return best;
}

}  // namespace

std::optional<DirectionalLossFit> fit_directional_loss(const scene::Material& material, const Eigen::Matrix3d& axes,
                                                       const std::vector<StrainedDecay>& decays) {
  const DirectionalDecays directional(material, axes, decays);
  constexpr double usual = 0.01;
  Fit fit = directional.best({}, Eigen::VectorXd::Constant(1, std::log(usual)));
  const auto count = static_cast<Eigen::Index>(decays.size());
  constexpr double exact = 1e-3;  // of a rate
  while (2 * (fit.unknowns() + 1) <= count && fit.squares > exact * exact * static_cast<double>(count)) {
    const std::optional<Fit> finer = with_one_more(directional, fit);
    const auto freedom = static_cast<double>(count - fit.unknowns() - 1);
    constexpr double clearly = 2.0;  // times the bound of one number, because the best of six is taken
    if (!finer || fit.squares - finer->squares < std::pow(clearly * student_t(freedom), 2) * finer->squares / freedom) {
      break;
    }
    fit = *finer;
  }
  if (fit.unknowns() == 1) {
    return {};
  }
  return DirectionalLossFit{loss_of(fit.places, fit.logarithms), fit.squares};
}

}  // namespace idiophone::fitting
