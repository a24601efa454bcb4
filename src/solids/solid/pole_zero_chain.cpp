#include "pole_zero_chain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "idiophone/foundation/dense/dense.hpp"

namespace idiophone::solid {

namespace {

constexpr double tolerance = 0.0475;  // of the loss factor within the band, so that decay times are within 5 %
constexpr double curve_tolerance = 0.25;
constexpr int most_mechanisms = 12;

/// A loss factor over the logarithm of the frequency.
class LogBand {
 public:
  explicit LogBand(const scene::LossFactor& loss)
      : loss_(loss),
        low_(std::log(2 * std::numbers::pi * loss.band[0])),
        high_(std::log(2 * std::numbers::pi * loss.band[1])) {}

  /// ln(w) at a part of the band.
  [[nodiscard]] double at(double part) const { return low_ + part * (high_ - low_); }
  /// ln(w) of evenly spread points.
  [[nodiscard]] Eigen::VectorXd points(Eigen::Index count) const {
    Eigen::VectorXd all(count);
    for (Eigen::Index p = 0; p < count; ++p) {
      all[p] = at(static_cast<double>(p) / static_cast<double>(count - 1));
    }
    return all;
  }
  /// tan(phi)
  [[nodiscard]] double loss(double log_frequency) const {
    return loss_.at(std::exp(log_frequency) / (2 * std::numbers::pi));
  }
  /// Phase of the largest loss factor.
  [[nodiscard]] double largest_phase() const { return std::atan(loss_.value); }

 private:
  const scene::LossFactor& loss_;
  double low_;
  double high_;
};

double phase(const PoleZeroChain& chain, double log_frequency) {
  double sum = 0.0;
  for (std::size_t i = 0; i < chain.centres.size(); ++i) {
    sum += std::atan(std::sinh(chain.strengths[i]) / std::cosh(log_frequency - chain.centres[i]));
  }
  return sum;
}

/// The strengths, as shares of the largest phase, whose phases are nearest to those that are wanted: their largest
/// error, of itself, is nearly as small as it can be (Lawson's reweighted least squares).
/// @param points  ln(w)
Eigen::VectorXd best_strengths(const LogBand& band, const Eigen::VectorXd& points, const std::vector<double>& centres) {
  Eigen::MatrixXd phases(points.size(), std::ssize(centres));  // of pairs of strength 1, over those that are wanted
  for (Eigen::Index p = 0; p < points.size(); ++p) {
    const double wanted = std::atan(band.loss(points[p])) / band.largest_phase();
    for (Eigen::Index i = 0; i < phases.cols(); ++i) {
      phases(p, i) = 1 / std::cosh(points[p] - centres[static_cast<std::size_t>(i)]) / wanted;
    }
  }
  Eigen::VectorXd strengths;
  Eigen::VectorXd weight = Eigen::VectorXd::Ones(points.size());
  for (int iteration = 0; iteration < 10; ++iteration) {
    const Eigen::VectorXd root = weight.cwiseSqrt();
    strengths = dense::least_squares(root.asDiagonal() * phases, root);
    weight = weight.cwiseProduct(((phases * strengths).array() - 1.0).abs().matrix());
    weight /= std::max(weight.sum(), std::numeric_limits<double>::min());
  }
  return strengths;
}

/// Evenly spread pairs, the first and last an inset (part of the band) away from its ends. Pairs that a curve has no
/// use for are left out.
PoleZeroChain fit(const scene::LossFactor& loss, int count, double inset) {
  const LogBand band(loss);
  const Eigen::VectorXd points = band.points(20 * count + 1);
  PoleZeroChain chain;
  for (int i = 0; i < count; ++i) {
    chain.centres.push_back(band.at(count == 1 ? 0.5 : inset + i * (1 - 2 * inset) / (count - 1)));
  }
  Eigen::VectorXd strengths = best_strengths(band, points, chain.centres);
  Eigen::Index least = 0;
  while (strengths.minCoeff(&least) <= 0) {
    if (loss.curve.empty() || chain.centres.size() == 1) {
      return chain;
    }
    chain.centres.erase(chain.centres.begin() + least);
    strengths = best_strengths(band, points, chain.centres);
  }
  strengths *= band.largest_phase();
  chain.strengths.assign(strengths.begin(), strengths.end());
  chain.deviation = 0.0;
  for (const double x : points) {
    chain.deviation = std::max(chain.deviation, std::abs(std::tan(phase(chain, x)) / band.loss(x) - 1));
  }
  return chain;
}

/// The best chain of so many pairs. A curve that rises or falls at an end of its band may need a pair beyond it.
PoleZeroChain best_fit(const scene::LossFactor& loss, int count) {
  PoleZeroChain best;
  constexpr double step = 0.01;
  constexpr int insets = 25;
  const int beyond = loss.curve.empty() ? 0 : insets;
  double inset = -step * beyond;
  for (int i = 0; i < beyond + insets; ++i, inset += step) {
    PoleZeroChain chain = fit(loss, count, inset);
    if (chain.deviation < best.deviation) {
      best = std::move(chain);
    }
  }
  return best;
}

/// The chain with fewest pairs that keeps the tolerance; if none does, that with fewest of those that are nearly as
/// close as the closest.
PoleZeroChain shortest_fit(const scene::LossFactor& loss) {
  constexpr double nearly = 1.05;
  std::vector<PoleZeroChain> chains;
  double closest = std::numeric_limits<double>::infinity();
  for (int count = 1; count <= most_mechanisms; ++count) {
    chains.push_back(best_fit(loss, count));
    closest = std::min(closest, chains.back().deviation);
    if (closest <= tolerance) {
      return chains.back();
    }
  }
  return *std::ranges::find_if(chains, [&](const auto& chain) { return chain.deviation <= nearly * closest; });
}

std::string aim(const scene::LossFactor& loss) {
  const auto& [low, high] = loss.band;
  return loss.curve.empty()
             ? fmt::format("loss factor {:.4g} within 5 % from {:.6g} to {:.6g} Hz", loss.value, low, high)
             : fmt::format("loss factor over the frequency within {:.0f} %", 100 * curve_tolerance);
}

}  // namespace

PoleZeroChain fitted_chain(const scene::LossFactor& loss) {
  const double allowed = loss.curve.empty() ? tolerance : curve_tolerance;
  PoleZeroChain shortest = shortest_fit(loss);
  if (!(shortest.deviation <= allowed)) {
    throw deck::DeckError(
        loss.where,
        fmt::format("{} mechanisms can't keep the {}: make {}", most_mechanisms, aim(loss),
                    loss.curve.empty() ? "the band narrower or the loss smaller" : "it rise and fall more gently"));
  }
  if (!loss.mechanisms) {
    return shortest;
  }
  PoleZeroChain chain = best_fit(loss, *loss.mechanisms);
  if (!(chain.deviation <= allowed)) {
    throw deck::DeckError(loss.where, fmt::format("{} mechanisms can't keep the {}: {} can; leave `mechanisms` out, "
                                                  "or change the band",
                                                  *loss.mechanisms, aim(loss), shortest.centres.size()));
  }
  return chain;
}

}  // namespace idiophone::solid
