// How long steps of many ranks take.

#include "idiophone/study/advice/rank_steps.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace idiophone::advice {
namespace {

constexpr Network network{.latency = 22e-6, .overhead = 1e-6, .bandwidth = 1e9};  // 20 us on the way

/// A chain: each exchanges 1000 bytes, which take 1 us, with the next one.
RankSteps chain(const std::vector<double>& computing, int steps_per_full_wait) {
  RankSteps steps{.steps_per_full_wait = steps_per_full_wait, .ranks = {}};
  for (const double seconds : computing) {
    steps.ranks.push_back({.computing = seconds, .inner = 4e-6, .received = {}});
  }
  for (int rank = 1; rank < static_cast<int>(computing.size()); ++rank) {
    steps.ranks[rank].received.push_back({.sender = rank - 1, .bytes = 1000});
    steps.ranks[rank - 1].received.push_back({.sender = rank, .bytes = 1000});
  }
  return steps;
}

TEST(RankSteps, OneRankWaitsForNobody) {
  const StepTime time = step_time(chain({10e-6}, 5), network);
  EXPECT_EQ(time.whole, 10e-6);
  EXPECT_EQ(time.waiting, 0.0);
}

TEST(RankSteps, TwoRanksWaitForWhatInnerWorkDoesNotHide) {
  const StepTime never = step_time(chain({10e-6, 10e-6}, 0), network);
  EXPECT_NEAR(never.whole, 10e-6 + 2e-6 + 21e-6 - 4e-6, 1e-12);
  EXPECT_NEAR(never.waiting, 21e-6 - 4e-6, 1e-12);
  EXPECT_NEAR(step_time(chain({10e-6, 10e-6}, 2), network).whole, 10e-6 + 2e-6 + 21e-6 - 2e-6, 1e-12);
}

TEST(RankSteps, ARankWaitsHalfAsLongForOneThatIsFaster) {
  EXPECT_NEAR(step_time(chain({10e-6, 20e-6}, 0), network).whole, 15e-6 + 2e-6 + 21e-6 - 4e-6, 1e-12);
  EXPECT_NEAR(step_time(chain({10e-6, 100e-6}, 0), network).whole, 100e-6 + 2e-6, 1e-12);
}

TEST(RankSteps, RanksOfAHostShareItsMemoryAndItsBandwidth) {
  Network hosts = network;
  hosts.ranks_on_host = 2;
  const double near = 2 * shared_memory.overhead;
  EXPECT_NEAR(step_time(chain({10e-6, 10e-6}, 0), hosts).whole, 10e-6 + near, 1e-12);
  EXPECT_NEAR(step_time(chain({10e-6, 10e-6, 10e-6, 10e-6}, 0), hosts).whole, 10e-6 + near + 2e-6 + 21e-6 - 4e-6,
              1e-12);
}

}  // namespace
}  // namespace idiophone::advice
