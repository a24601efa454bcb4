// How long steps of many ranks take.

#include "idiophone/study/advice/rank_steps.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "ranks.hpp"
#include "shared_network.hpp"

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

ON_RANKS(1);

TEST(RankSteps, OneRankWaitsForNobody) {
  const StepTime time = step_time(chain({10e-6}, 5), network);
  EXPECT_NEAR(time.whole, 10e-6, 1e-15);
  EXPECT_NEAR(time.waiting, 0.0, 1e-15);
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

TEST(RankSteps, AMessageInOneDirectionDelaysNobodyElse) {
  RankSteps steps = chain({10e-6, 20e-6}, 0);
  steps.ranks[0].received.clear();  // it runs ahead of the other one
  EXPECT_NEAR(step_time(steps, network).whole, 20e-6 + 2e-6, 1e-12);
}

TEST(RankSteps, PairsOnTwoHostsShareTheirBandwidth) {
  RankSteps pairs{.steps_per_full_wait = 0, .ranks = {}};
  for (const int other : {2, 3, 0, 1}) {
    pairs.ranks.push_back({.computing = 10e-6, .inner = 4e-6, .received = {{.sender = other, .bytes = 10000}}});
  }
  Network hosts = network;
  hosts.ranks_on_host = 2;
  EXPECT_NEAR(step_time(pairs, hosts).whole, 6e-6 + 2e-6 + 20e-6 + 20e-6, 1e-12);  // 10 us alone
}

// 1000 bytes/s
TEST(SharedNetwork, AMessageGetsAllThatOthersLeave) {
  SharedNetwork hosts(2, 1000.0);
  EXPECT_EQ(hosts.next_end(), std::numeric_limits<double>::infinity());
  hosts.enter(0.0, 0, 1, 1000.0, {.receiver = 1});
  hosts.enter(0.5, 0, 1, 1000.0, {.receiver = 2});
  EXPECT_NEAR(hosts.next_end(), 1.5, 1e-12);  // half of the first is left, at half the bandwidth
  EXPECT_EQ(hosts.leave().receiver, 1);
  EXPECT_NEAR(hosts.next_end(), 2.0, 1e-12);
  EXPECT_EQ(hosts.leave().receiver, 2);
  hosts.enter(3.0, 1, 0, 500.0, {.receiver = 3});
  hosts.enter(3.0, 0, 1, 600.0, {.receiver = 4});  // both ways at once
  EXPECT_NEAR(hosts.next_end(), 3.5, 1e-12);
}

TEST(SharedNetwork, AMessageTravelsWithTheSmallerPart) {
  SharedNetwork hosts(4, 1000.0);
  hosts.enter(0.0, 0, 1, 1000.0, {.receiver = 1});
  hosts.enter(0.0, 0, 2, 1000.0, {.receiver = 2});
  hosts.enter(0.0, 3, 2, 500.0, {.receiver = 3});
  EXPECT_NEAR(hosts.next_end(), 1.0, 1e-12);  // half of what host 2 receives
  EXPECT_EQ(hosts.leave().receiver, 3);
  EXPECT_NEAR(hosts.next_end(), 2.0, 1e-12);  // half of what host 0 sends, though host 2 could receive more
}

}  // namespace
}  // namespace idiophone::advice
