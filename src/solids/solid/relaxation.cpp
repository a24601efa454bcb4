// The modulus is sought as M(s) = K prod_i (s + z_i)/(s + p_i), with zeros and poles z_i, p_i = w_i exp(-+ y_i). At
// s = i w a pair adds the phase atan(sinh(y_i)/cosh(ln(w/w_i))), nearly y_i/cosh(ln(w/w_i)): the y_i that make the
// phase constant are the solution of linear equations. Positive y_i of pairs that do not overlap give partial fractions
// with positive weights, which is the generalised Maxwell solid.

#include "idiophone/solids/solid/relaxation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "idiophone/foundation/dense/dense.hpp"

namespace idiophone::solid {

namespace {

constexpr double tolerance = 0.0475;  // of the loss factor within the band, so that decay times are within 5 %
constexpr int most_mechanisms = 12;

/// Pole-zero pairs, and how far the loss factor strays in the band.
struct Chain {
  std::vector<double> centres;                                 ///< ln(w_i)
  std::vector<double> strengths;                               ///< y_i
  double deviation = std::numeric_limits<double>::infinity();  ///< largest |tan(phi)/loss factor - 1| in the band
};

struct LogBand {
  double low;   ///< ln(w)
  double high;  ///< ln(w)

  explicit LogBand(const scene::LossFactor& loss)
      : low(std::log(2 * std::numbers::pi * loss.band[0])), high(std::log(2 * std::numbers::pi * loss.band[1])) {}
  [[nodiscard]] double at(double part) const { return low + part * (high - low); }
};

double phase(const Chain& chain, double log_frequency) {
  double sum = 0.0;
  for (std::size_t i = 0; i < chain.centres.size(); ++i) {
    sum += std::atan(std::sinh(chain.strengths[i]) / std::cosh(log_frequency - chain.centres[i]));
  }
  return sum;
}

/// Evenly spread pairs, the first and last an inset (part of the band) away from its ends; of their phases, the largest
/// error is nearly as small as it can be (Lawson's reweighted least squares).
Chain fit(const scene::LossFactor& loss, int count, double inset) {
  const LogBand band(loss);
  const Eigen::Index points = 20 * count + 1;
  Chain chain;
  for (int i = 0; i < count; ++i) {
    chain.centres.push_back(band.at(count == 1 ? 0.5 : inset + i * (1 - 2 * inset) / (count - 1)));
  }
  Eigen::MatrixXd phases(points, count);  // of pairs of strength 1
  for (Eigen::Index p = 0; p < points; ++p) {
    const double x = band.at(static_cast<double>(p) / static_cast<double>(points - 1));
    for (Eigen::Index i = 0; i < count; ++i) {
      phases(p, i) = 1 / std::cosh(x - chain.centres[i]);
    }
  }
  Eigen::VectorXd strengths;
  Eigen::VectorXd weight = Eigen::VectorXd::Ones(points);
  for (int iteration = 0; iteration < 10; ++iteration) {
    const Eigen::VectorXd root = weight.cwiseSqrt();
    strengths = dense::least_squares(root.asDiagonal() * phases, root);
    weight = weight.cwiseProduct(((phases * strengths).array() - 1.0).abs().matrix());
    weight /= std::max(weight.sum(), std::numeric_limits<double>::min());
  }
  if (strengths.minCoeff() <= 0) {
    return chain;
  }
  strengths *= std::atan(loss.value);
  chain.strengths.assign(strengths.begin(), strengths.end());
  chain.deviation = 0.0;
  for (Eigen::Index p = 0; p < points; ++p) {
    const double tangent = std::tan(phase(chain, band.at(static_cast<double>(p) / static_cast<double>(points - 1))));
    chain.deviation = std::max(chain.deviation, std::abs(tangent / loss.value - 1));
  }
  return chain;
}

/// The best chain of so many pairs.
Chain best_fit(const scene::LossFactor& loss, int count) {
  Chain best;
  constexpr int insets = 25;
  double inset = 0.0;
  for (int i = 0; i < insets; ++i, inset += 0.01) {
    Chain chain = fit(loss, count, inset);
    if (chain.deviation < best.deviation) {
      best = std::move(chain);
    }
  }
  return best;
}

/// The chain with fewest pairs that keeps the tolerance.
std::optional<Chain> shortest_fit(const scene::LossFactor& loss) {
  for (int count = 1; count <= most_mechanisms; ++count) {
    Chain chain = best_fit(loss, count);
    if (chain.deviation <= tolerance) {
      return chain;
    }
  }
  return {};
}

Chain demanded_fit(const scene::LossFactor& loss) {
  const std::string aim =
      fmt::format("loss factor {:.4g} within 5 % from {:.6g} to {:.6g} Hz", loss.value, loss.band[0], loss.band[1]);
  const std::optional<Chain> shortest = shortest_fit(loss);
  if (!shortest) {
    throw deck::DeckError(loss.where,
                          fmt::format("{} mechanisms can't keep the {}: make the band narrower or the loss smaller",
                                      most_mechanisms, aim));
  }
  if (!loss.mechanisms) {
    return *shortest;
  }
  Chain chain = best_fit(loss, *loss.mechanisms);
  if (!(chain.deviation <= tolerance)) {
    throw deck::DeckError(loss.where, fmt::format("{} mechanisms can't keep the {}: {} can; leave `mechanisms` out, "
                                                  "or change the band",
                                                  *loss.mechanisms, aim, shortest->centres.size()));
  }
  return chain;
}

}  // namespace

double Relaxation::instantaneous() const {
  double sum = long_term;
  for (const Mechanism& mechanism : mechanisms) {
    sum += mechanism.strength;
  }
  return sum;
}

double Relaxation::instantaneous_damping() const {
  double sum = 0.0;
  for (const Mechanism& mechanism : mechanisms) {
    sum += mechanism.strength * mechanism.rate;
  }
  return sum / instantaneous();
}

std::complex<double> Relaxation::modulus(double frequency) const {
  const std::complex<double> s(0.0, frequency);
  std::complex<double> sum = long_term;
  for (const Mechanism& mechanism : mechanisms) {
    sum += mechanism.strength * s / (s + mechanism.rate);
  }
  return sum;
}

Relaxation fit_relaxation(const scene::LossFactor& loss) {
  const Chain chain = demanded_fit(loss);
  const std::size_t count = chain.centres.size();
  const auto zero = [&](std::size_t i) { return std::exp(chain.centres[i] - chain.strengths[i]); };
  const auto pole = [&](std::size_t i) { return std::exp(chain.centres[i] + chain.strengths[i]); };
  Relaxation relaxation;  // K = 1 at first
  for (std::size_t i = 0; i < count; ++i) {
    relaxation.long_term *= zero(i) / pole(i);
    double strength = -std::expm1(-2 * chain.strengths[i]);  // 1 - z_i/p_i
    for (std::size_t j = 0; j < count; ++j) {
      strength *= j == i ? 1.0 : (zero(j) - pole(i)) / (pole(j) - pole(i));
    }
    relaxation.mechanisms.push_back({strength, pole(i)});
  }
  const double storage = relaxation.modulus(std::exp(LogBand(loss).at(0.5))).real();
  relaxation.long_term /= storage;
  for (Relaxation::Mechanism& mechanism : relaxation.mechanisms) {
    mechanism.strength /= storage;
  }
  return relaxation;
}

Relaxation creeping(const Relaxation& relaxation, double rate) {
  // Of the product of each mechanism with s/(s + rate), by partial fractions.
  Relaxation creeping{.long_term = 0.0, .mechanisms = {}};
  double strength = relaxation.long_term;
  for (const auto& [own_strength, own_rate] : relaxation.mechanisms) {
    creeping.mechanisms.push_back({own_strength * own_rate / (own_rate - rate), own_rate});
    strength -= own_strength * rate / (own_rate - rate);
  }
  creeping.mechanisms.push_back({strength, rate});
  return creeping;
}

}  // namespace idiophone::solid
