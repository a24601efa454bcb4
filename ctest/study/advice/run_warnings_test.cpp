#include "idiophone/study/advice/run_warnings.hpp"

#include <gmock/gmock.h>

#include "ranks.hpp"

namespace idiophone::advice {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Ten steps in an audio sample of 44.1 kHz.
bodies::Preparation with_load(const scene::Signal& signal) {
  bodies::Preparation ready;
  ready.steps_per_sample = 10;
  ready.scene.time.duration = 0.5;
  ready.scene.pulses.emplace_back().name = "shaker";
  ready.scene.pulses.front().signal = signal;
  return ready;
}

scene::Signal sine(double frequency) {
  return {.shape = scene::Signal::Shape::sine, .duration = 1.0, .frequency = frequency, .table = {}};
}

ON_RANKS(1);

TEST(RunWarnings, TellOfLoadsThatNobodyHears) {
  EXPECT_THAT(run_warnings(with_load(sine(20000))), IsEmpty());
  EXPECT_THAT(run_warnings(with_load(sine(30000))),
              ElementsAre(AllOf(HasSubstr("load shaker has 30000 Hz"), HasSubstr("above 22050 Hz"))));
}

TEST(RunWarnings, TellOfLoadsThatTheStepsDoNotFollow) {
  EXPECT_THAT(run_warnings(with_load(sine(440000))), ElementsAre(HasSubstr("only follow up to 220500 Hz")));
  EXPECT_THAT(run_warnings(with_load({.duration = 1e-4, .table = {}})), IsEmpty());
  EXPECT_THAT(run_warnings(with_load({.duration = 5e-6, .table = {}})), ElementsAre(HasSubstr("is 2.2 steps of")));
}

TEST(RunWarnings, TellOfLoadsThatStartAfterTheEnd) {
  EXPECT_THAT(run_warnings(with_load({.start = 0.49, .duration = 0.1, .table = {}})), IsEmpty());
  const bodies::Preparation late = with_load({.start = 0.5, .duration = 0.1, .table = {}});
  EXPECT_THAT(run_warnings(late), ElementsAre(HasSubstr("load shaker starts at 0.5 s and never acts")));
  bodies::Preparation bowed = with_load(sine(100));
  bowed.scene.bows.emplace_back().name = "bow";
  bowed.scene.bows.front().start = 0.6;
  EXPECT_THAT(run_warnings(bowed), ElementsAre(HasSubstr("load bow starts at 0.6 s")));
}

TEST(RunWarnings, TellOfDrivenGroups) {
  bodies::Preparation ready;
  ready.scene.time.duration = 0.5;
  ready.steps_per_sample = 10;
  ready.scene.radiation.model = scene::RadiationModel::huygens;
  ready.scene.bodies.emplace_back().name = "plate";
  ready.statistics.resize(1);
  auto& group = ready.scene.bodies.front().driven.emplace_back();
  group.group = "rim";
  group.signal = sine(30000);
  EXPECT_THAT(run_warnings(ready), ElementsAre(HasSubstr("the driven group rim of body plate has 30000 Hz")));
}

}  // namespace
}  // namespace idiophone::advice
