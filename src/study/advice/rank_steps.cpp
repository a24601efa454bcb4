#include "idiophone/study/advice/rank_steps.hpp"

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "step_replay.hpp"

namespace idiophone::advice {

StepTime step_time(const RankSteps& steps, const Network& network) {
  StepReplay replay(steps, network);
  constexpr int at_least = 64;  // the mean changes by a few per cent until then
  const int period = std::max(1, steps.steps_per_full_wait);
  const int count = (at_least + period - 1) / period * period;
  const std::vector<double> ends = replay.ends(2 * count);  // the first half forgets that all ranks begin at once
  const double whole = (ends[2 * count - 1] - ends[count - 1]) / count;
  double busiest = 0.0;
  for (int rank = 0; rank < std::ssize(steps.ranks); ++rank) {
    busiest = std::max(busiest, replay.computing(rank));
  }
  return {.whole = whole, .waiting = std::max(0.0, whole - busiest)};
}

nlohmann::json facts_of(const RankSteps& steps) {
  nlohmann::json ranks = nlohmann::json::array();
  for (const RankStep& step : steps.ranks) {
    nlohmann::json received = nlohmann::json::array();
    for (const Message& message : step.received) {
      received.push_back({message.sender, message.bytes});
    }
    ranks.push_back({{"computing_seconds", step.computing}, {"inner_seconds", step.inner}, {"received", received}});
  }
  return {{"steps_per_full_wait", steps.steps_per_full_wait}, {"ranks", std::move(ranks)}};
}

}  // namespace idiophone::advice
