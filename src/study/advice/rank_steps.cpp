#include "idiophone/study/advice/rank_steps.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <nlohmann/json.hpp>
#include <numeric>
#include <utility>
#include <vector>

namespace idiophone::advice {

namespace {

/// Messages that a host receives at once. They share its bandwidth evenly until each has arrived.
class HostMessages {
 public:
  void add(double bytes) { bytes_.push_back(bytes); }
  void sort() {
    std::ranges::sort(bytes_);
    sums_ = {0.0};
    std::inclusive_scan(bytes_.begin(), bytes_.end(), std::back_inserter(sums_));
  }

  /// What the host has received when one of these messages of so many bytes has arrived, bytes.
  [[nodiscard]] double received_with(double bytes) const {
    const auto smaller = std::ranges::lower_bound(bytes_, bytes) - bytes_.begin();
    return sums_[smaller] + bytes * static_cast<double>(std::ssize(bytes_) - smaller);
  }

 private:
  std::vector<double> bytes_;  // ascending, of each message
  std::vector<double> sums_;   // [messages + 1] of the first ones
};

class RankTimes {
 public:
  RankTimes(const RankSteps& steps, const Network& network)
      : steps_(steps), network_(network), hosts_(steps.ranks.size() / network.ranks_on_host + 1) {
    for (std::size_t rank = 0; rank < steps.ranks.size(); ++rank) {
      computing_.push_back(steps.ranks[rank].computing);
      for (const Message& message : steps.ranks[rank].received) {
        computing_.back() += 2 * network_of(message, rank).overhead;  // one received, one sent
        if (!is_near(message, rank)) {
          hosts_[host_of(rank)].add(message.bytes);
        }
      }
    }
    std::ranges::for_each(hosts_, &HostMessages::sort);
  }

  /// What a rank computes, with the overhead of its messages, s.
  [[nodiscard]] double computing(std::size_t rank) const { return computing_[rank]; }

  /// From the sending of a message until its receiver sends its own, s.
  [[nodiscard]] double until_sent(const Message& message, std::size_t receiver) const {
    const double bytes =
        is_near(message, receiver) ? message.bytes : hosts_[host_of(receiver)].received_with(message.bytes);
    const Network& way = network_of(message, receiver);
    const double travelling = way.latency - 2 * way.overhead + bytes / way.bandwidth;
    const double hidden = network_.is_shared_memory ? 0.0 : std::min(travelling, steps_.ranks[receiver].inner);
    const int period = steps_.steps_per_full_wait;
    const double hiding_steps = period > 0 ? 1.0 - 1.0 / period : 1.0;  // share of all
    return computing_[receiver] + travelling - hidden * hiding_steps;
  }

 private:
  [[nodiscard]] std::size_t host_of(std::size_t rank) const { return rank / network_.ranks_on_host; }
  [[nodiscard]] bool is_near(const Message& message, std::size_t receiver) const {
    return host_of(message.sender) == host_of(receiver);
  }
  [[nodiscard]] const Network& network_of(const Message& message, std::size_t receiver) const {
    return is_near(message, receiver) ? shared_memory : network_;
  }

  const RankSteps& steps_;
  const Network& network_;
  std::vector<HostMessages> hosts_;
  std::vector<double> computing_;  // [ranks] with the overhead of their messages, s
};

/// What a rank receives from another; null for nothing.
const Message* message_to(const RankSteps& steps, std::size_t receiver, std::size_t sender) {
  const std::vector<Message>& received = steps.ranks[receiver].received;
  const auto found =
      std::ranges::find_if(received, [&](const Message& message) { return std::cmp_equal(message.sender, sender); });
  return found == received.end() ? nullptr : &*found;
}

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
    const double own = times.computing(rank);
    compare(own, own);
    for (const Message& message : steps.ranks[rank].received) {
      if (const Message* const answer = message_to(steps, message.sender, rank)) {
        const double there_and_back = times.until_sent(message, rank) + times.until_sent(*answer, message.sender);
        compare(there_and_back / 2, std::max(own, times.computing(message.sender)));
      }
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
