// Clocks of stages.

#include "idiophone/foundation/parallel/stages.hpp"

#include <gtest/gtest.h>

#include "idiophone/foundation/parallel/clock.hpp"
#include "ranks.hpp"
#include "stages.hpp"

namespace idiophone::parallel {
namespace {

ON_RANKS(1);

void work(double seconds) {
  const double end = wall_time() + seconds;
  while (wall_time() < end) {
  }
}

TEST(Stages, CountTheTimeOfAnInnerScopeOnce) {
  Stages& stages = support::stages();
  const Stages before = stages;
  const auto seconds = [&](Stage stage) { return stages.seconds(stage) - before.seconds(stage); };
  const double begun = wall_time();
  {
    const Stages::Scope outer(stages, Stage::store);
    { const Stages::Scope inner(stages, Stage::motion); }
    const Stages::Scope inner(stages, Stage::radiation);
    work(0.01);
  }
  const double passed = wall_time() - begun;
  EXPECT_GE(seconds(Stage::radiation), 0.01);
  EXPECT_GE(seconds(Stage::store), 0.0);
  EXPECT_LE(seconds(Stage::store) + seconds(Stage::motion) + seconds(Stage::radiation), passed);
}

}  // namespace
}  // namespace idiophone::parallel
