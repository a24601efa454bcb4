#pragma once
// What waves on a grid need and gain on many ranks, predicted by one process from the subdomains.

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "idiophone/air/waves/plan.hpp"
#include "idiophone/study/advice/network.hpp"
#include "idiophone/study/advice/rank_steps.hpp"

namespace idiophone::advice {

/// How long steps of waves take.
struct WaveTimes {
  RankSteps steps;
  StepTime step;
  double speed_up = 1.0;  ///< over one rank
};

struct WavePrediction {
  double cells = 0.0;       ///< of the largest subdomain
  int neighbours = 0;       ///< largest number of any rank
  double halo_bytes = 0.0;  ///< largest number of any rank: pressures of ghost cells that it receives in a step
  double memory = 0.0;      ///< of the largest subdomain, bytes
  std::optional<WaveTimes> times = {};  ///< none: it is not known how long one rank takes
};

/// Divides the grid as a run does. The time is divided like the cells, wherever they lie. Messages travel while inner
/// cells are computed.
/// @param one  time of a step on one rank, s; none if it is not known
/// @throws std::runtime_error when there are more ranks than pieces of rows
[[nodiscard]] WavePrediction predict_waves(const waves::Plan& plan, int ranks, std::optional<double> one,
                                           const Network& network);

void report(const WavePrediction& prediction);

[[nodiscard]] nlohmann::json facts_of(const WavePrediction& prediction);

}  // namespace idiophone::advice
