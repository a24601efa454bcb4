// Waves on many ranks, predicted.

#include "idiophone/study/advice/wave_prediction.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <optional>

#include "ranks.hpp"

namespace idiophone::advice {
namespace {

constexpr double one = 1e-3;  // s, of a step on one rank

waves::Plan cubic_grid(int cells) {
  waves::Plan plan;
  plan.grid.cells = {cells, cells, cells};
  return plan;
}

ON_RANKS(1);

TEST(WavePrediction, OfOneRankIsThatRank) {
  const WavePrediction found = predict_waves(cubic_grid(64), 1, one, Network{});
  EXPECT_EQ(found.cells, 64.0 * 64 * 64);
  EXPECT_EQ(found.neighbours, 0);
  EXPECT_EQ(found.halo_bytes, 0.0);
  EXPECT_NEAR(found.times.value().speed_up, 1.0, 1e-12);
}

TEST(WavePrediction, TwoRanksShareAFace) {
  const Network slow{.latency = 1e-3, .overhead = 1e-5, .bandwidth = 1e6};
  const WavePrediction found = predict_waves(cubic_grid(64), 2, one, slow);
  EXPECT_EQ(found.cells, 32.0 * 64 * 64);
  EXPECT_EQ(found.neighbours, 1);
  EXPECT_EQ(found.halo_bytes, 64.0 * 64 * 4);
  const double overheads = 2e-5;  // of a message sent and one received
  const double exchange = 1e-3 - overheads + 64.0 * 64 * 4 / 1e6;
  const double inner = one * 31 / 64;  // one layer of cells is computed before
  const WaveTimes times = found.times.value();
  EXPECT_NEAR(times.step.waiting, exchange - inner, 1e-12);
  EXPECT_NEAR(times.step.whole, one / 2 + overheads + exchange - inner, 1e-12);
  EXPECT_NEAR(times.speed_up, one / times.step.whole, 1e-12);
}

TEST(WavePrediction, InnerCellsHideFastMessages) {
  const Network fast{.latency = 1e-6, .bandwidth = 1e9};
  EXPECT_NEAR(predict_waves(cubic_grid(64), 2, one, fast).times.value().step.waiting, 0.0, 1e-15);
  const Network shared{.latency = 1e-6, .bandwidth = 1e9, .is_shared_memory = true};
  EXPECT_GT(predict_waves(cubic_grid(64), 2, one, shared).times.value().step.waiting, 0.0);
}

TEST(WavePrediction, OnlyTheTimesNeedTheTimeOfOneRank) {
  const WavePrediction found = predict_waves(cubic_grid(64), 2, std::nullopt, Network{});
  EXPECT_FALSE(found.times);
  const nlohmann::json facts = facts_of(found), with_times = facts_of(predict_waves(cubic_grid(64), 2, one, Network{}));
  for (const char* of_the_grid : {"cells", "neighbours", "halo_bytes", "memory_bytes"}) {
    EXPECT_GT(facts.at(of_the_grid), 0) << of_the_grid;
    EXPECT_EQ(facts.at(of_the_grid), with_times.at(of_the_grid)) << of_the_grid;
  }
  for (const char* time : {"step_seconds", "waiting_seconds", "speed_up"}) {
    EXPECT_TRUE(facts.at(time).is_null()) << time;
    EXPECT_TRUE(with_times.at(time).is_number()) << time;
  }
}

}  // namespace
}  // namespace idiophone::advice
