#pragma once
// What each rank computes and receives in a step, and how long the step takes for all of them.

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "idiophone/study/advice/network.hpp"

namespace idiophone::advice {

struct Message {
  int sender = 0;      ///< a rank
  double bytes = 0.0;  ///< in each step
};

/// One rank's step.
struct RankStep {
  double computing = 0.0;  ///< processor time, s
  double inner = 0.0;      ///< of it, while the messages travel, s
  std::vector<Message> received;
};

struct RankSteps {
  /// In one of so many steps, a rank waits for the messages before it computes anything. 0: never.
  int steps_per_full_wait = 0;
  std::vector<RankStep> ranks;
};

struct StepTime {
  double whole = 0.0;    ///< s
  double waiting = 0.0;  ///< of it, on the rank that computes longest, s
};

/// The mean over steps that are played one event after another, from what each rank computes and when its messages
/// arrive.
/// @throws std::out_of_range  for a sender that is no rank
[[nodiscard]] StepTime step_time(const RankSteps& steps, const Network& network);

/// For programs that simulate a network: see docs/use/running.md.
[[nodiscard]] nlohmann::json facts_of(const RankSteps& steps);

}  // namespace idiophone::advice
