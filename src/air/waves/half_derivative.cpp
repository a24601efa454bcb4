#include "half_derivative.hpp"

#include <cmath>
#include <numbers>

#include "idiophone/air/waves/grid.hpp"
#include "step_formulas.hpp"

namespace idiophone::waves {

namespace {

/// Corner frequencies of the relaxations, evenly spaced in their logarithm, Hz.
constexpr double lowest = 2.0, highest = 2e5;

/// Their weights over the square roots of the corner frequencies in rad/s: least squares from 20 Hz to 20 kHz.
constexpr std::array fitted = {1.01252573, 0.49220353, 0.519647,   0.52471587,
                               0.52471587, 0.519647,   0.49220353, 1.01252573};

std::size_t whole_vectors(std::size_t length) {
  return (length + Grid::row_multiple - 1) / Grid::row_multiple * Grid::row_multiple;
}

}  // namespace

HalfDerivative::HalfDerivative(std::vector<float> ratios, double step) : ratios_(std::move(ratios)) {
  ratios_.resize(whole_vectors(ratios_.size()));
  for (std::size_t k = 0; k < terms; ++k) {
    const double corner = lowest * std::pow(highest / lowest, static_cast<double>(k) / (terms - 1));
    const double turn = 2.0 * std::numbers::pi * corner * step;
    weight_.at(k) = static_cast<float>(fitted.at(k) * std::sqrt(turn) / (1.0 + turn / 2.0));
    pace_.at(k) = static_cast<float>(turn / (1.0 + turn / 2.0));
    all_weights_ += weight_.at(k);
    past_.at(k).resize(length());
  }
}

void HalfDerivative::losses(std::span<const float> value, std::span<const float> gain, std::span<float> loss) const {
  const std::size_t count = length();
  float* const __restrict lost = loss.data();
  for (std::size_t i = 0; i < count; ++i) {
    lost[i] = loss_without_past(all_weights_, value[i], gain[i]);
  }
  for (std::size_t k = 0; k < terms; ++k) {
    const float* const past = past_[k].data();
    const float weight = weight_[k];
    for (std::size_t i = 0; i < count; ++i) {
      lost[i] -= weight * past[i];
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    lost[i] = loss_in_step(lost[i], all_weights_, ratios_[i]);
  }
}

void HalfDerivative::advance(std::span<const float> value, std::span<const float> gain, std::span<const float> loss) {
  const std::size_t count = length();
  for (std::size_t k = 0; k < terms; ++k) {
    float* const __restrict past = past_[k].data();
    const float pace = pace_[k];
    for (std::size_t i = 0; i < count; ++i) {
      past[i] = past_after_step(past[i], pace, value[i], gain[i], loss[i]);
    }
  }
}

void HalfDerivative::rest(std::size_t quantity, float value) {
  for (auto& past : past_) {
    past[quantity] = value;
  }
}

void HalfDerivative::copy(std::size_t quantity, const HalfDerivative& from, std::size_t its) {
  for (std::size_t k = 0; k < terms; ++k) {
    past_[k][quantity] = from.past_[k][its];
  }
}

void HalfDerivative::archive(std::size_t quantity, parallel::ArchiveRow& row) {
  for (auto& past : past_) {
    row.value(past[quantity]);
  }
}

}  // namespace idiophone::waves
