#include "idiophone/study/advice/rank_steps.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

namespace idiophone::advice {

namespace {

/// Of one rank in a step, s.
struct RankTime {
  double computing = 0.0;      ///< with the overhead of its messages
  double with_messages = 0.0;  ///< from a neighbour's sending to its own
};

class RankTimes {
 public:
  RankTimes(const RankSteps& steps, const Network& network)
      : steps_(steps), network_(network), host_bytes_(steps.ranks.size() / network.ranks_on_host + 1) {
    for (std::size_t rank = 0; rank < steps.ranks.size(); ++rank) {
      for (const Message& message : steps.ranks[rank].received) {
        host_bytes_[host_of(rank)] += host_of(message.sender) == host_of(rank) ? 0.0 : message.bytes;
      }
    }
  }

  [[nodiscard]] RankTime of(std::size_t rank) const {
    const RankStep& step = steps_.ranks[rank];
    double overheads = 0.0;
    double travelling = 0.0;
    for (const Message& message : step.received) {
      const bool is_near = host_of(message.sender) == host_of(rank);
      const Network& network = is_near ? shared_memory : network_;
      overheads += 2 * network.overhead;  // one received, one sent
      travelling = std::max(travelling, network.latency - 2 * network.overhead +
                                            (is_near ? message.bytes : host_bytes_[host_of(rank)]) / network.bandwidth);
    }
    const double hidden = network_.is_shared_memory ? 0.0 : std::min(travelling, step.inner);
    const int period = steps_.steps_per_full_wait;
    const double hiding_steps = period > 0 ? 1.0 - 1.0 / period : 1.0;  // share of all
    const double computing = step.computing + overheads;
    return {.computing = computing, .with_messages = computing + travelling - hidden * hiding_steps};
  }

 private:
  [[nodiscard]] std::size_t host_of(std::size_t rank) const { return rank / network_.ranks_on_host; }

  const RankSteps& steps_;
  const Network& network_;
  std::vector<double> host_bytes_;  // that each host receives from others
};

}  // namespace

StepTime step_time(const RankSteps& steps, const Network& network) {
  const RankTimes times(steps, network);
  StepTime slowest;
  const auto compare = [&](double whole, double computing) {
    if (whole > slowest.whole) {
      slowest = {.whole = whole, .waiting = std::max(0.0, whole - computing)};
    }
  };
  for (std::size_t rank = 0; rank < steps.ranks.size(); ++rank) {
    const RankTime own = times.of(rank);
    compare(own.computing, own.computing);
    for (const Message& message : steps.ranks[rank].received) {
      const RankTime other = times.of(message.sender);
      compare((own.with_messages + other.with_messages) / 2, std::max(own.computing, other.computing));
    }
  }
  return slowest;
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
