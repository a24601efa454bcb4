#pragma once
// Half a derivative in time of many quantities: what a boundary layer does to the air in front of it.

#include <array>
#include <span>
#include <vector>

#include "idiophone/foundation/parallel/archive_row.hpp"

namespace idiophone::waves {

/// Solves dx/dt + ratio d^(1/2)x/dt^(1/2) = gain for many x, step by step. The square root of i w is a sum of eight
/// relaxations, a i w/(i w + b) with a, b > 0, each in the trapezoidal rule. So it only takes energy, whatever the step
/// (Bilbao and Harrison 2016, "Passive time-domain numerical models of viscothermal wave propagation in acoustic tubes
/// of variable cross section"). It is exact to 0.6 % from 20 Hz to 20 kHz.
class HalfDerivative {
 public:
  HalfDerivative() = default;
  /// @param ratios  [quantities] over the square root of time, in steps
  /// @param step    s
  HalfDerivative(std::vector<float> ratios, double step);

  /// Length of the arrays below: the quantities, and some more.
  [[nodiscard]] std::size_t length() const { return ratios_.size(); }

  /// What the half derivative takes from the gain of a step.
  /// @param value  [length()] x before the step
  /// @param gain   [length()] of x in the step without the half derivative
  /// @param loss   [length()] overwritten
  void losses(std::span<const float> value, std::span<const float> gain, std::span<float> loss) const;

  /// Goes on by this step. `value` is still that before it.
  void advance(std::span<const float> value, std::span<const float> gain, std::span<const float> loss);

  /// A quantity that has had this value for ever.
  void rest(std::size_t quantity, float value);
  /// Takes the past of a quantity of another one.
  void copy(std::size_t quantity, const HalfDerivative& from, std::size_t its);
  void archive(std::size_t quantity, parallel::ArchiveRow& row);

  // For an accelerator:
  static constexpr std::size_t terms = 8;  ///< relaxations
  [[nodiscard]] const std::vector<float>& ratios() const { return ratios_; }
  /// Of each relaxation.
  [[nodiscard]] const std::array<float, terms>& weights() const { return weight_; }
  /// Of the past of each relaxation towards the present, per step.
  [[nodiscard]] const std::array<float, terms>& paces() const { return pace_; }
  [[nodiscard]] float all_weights() const { return all_weights_; }
  /// Of a relaxation: [length()].
  [[nodiscard]] const std::vector<float>& past(std::size_t term) const { return past_.at(term); }
  [[nodiscard]] std::vector<float>& past(std::size_t term) { return past_.at(term); }

 private:
  std::vector<float> ratios_;
  std::array<float, terms> weight_{}, pace_{};  // of a relaxation; of its past towards the present, per step
  float all_weights_ = 0.0F;
  std::array<std::vector<float>, terms> past_{};  // of each relaxation: [length()]
};

}  // namespace idiophone::waves
