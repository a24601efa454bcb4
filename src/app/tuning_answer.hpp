#pragma once
// What `idiophone tune` answers.

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "idiophone/study/fitting/tuning.hpp"
#include "idiophone/study/fitting/yield.hpp"

namespace idiophone::app {

/// How many bodies are in tune.
struct InTune {
  std::vector<fitting::Scatter> scatters;
  double within = 0.0;  ///< cents
  fitting::Yield yield;
};

struct TuningAnswer {
  const fitting::Tuning& tuning;
  const std::vector<fitting::Variable>& variables;
  const std::optional<InTune>& in_tune;
};

void print(const TuningAnswer& answer);

/// The same for scripts.
[[nodiscard]] nlohmann::json to_json(const TuningAnswer& answer);

/// What is not as it was wanted, as the beginning of a sentence.
/// @param tolerance, decay_tolerance  cents, percent
[[nodiscard]] std::string missed_remark(const fitting::Tuning& tuning, double tolerance, double decay_tolerance);

/// The numbers that sit on a bound, as the end of a sentence; empty if none does.
[[nodiscard]] std::string bounds_remark(const fitting::Tuning& tuning, const std::vector<fitting::Variable>& variables);

}  // namespace idiophone::app
