// Motions that have more energy than they were given are stopped.

#include "idiophone/run/bodies/stability_watch.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "memory_archive.hpp"
#include "ranks.hpp"
#include "shared_folder.hpp"

namespace idiophone::bodies {
namespace {

using ::testing::HasSubstr;

/// A body of 2 kg.
Preparation one_body() {
  Preparation ready;
  ready.scene.bodies.resize(1);
  ready.scene.audio.rate = 1000;
  ready.initial_state.masses = {2.0};
  ready.initial_state.steps.resize(1);
  ready.initial_state.steps[0].step = 1e-3;
  ready.steps_per_sample = 2;
  return ready;
}

Observation energies(double kinetic, double work = 0.0, double gravitational = 0.0) {
  Observation seen;
  seen.bodies.resize(1);
  seen.bodies[0].kinetic = kinetic;
  seen.work = work;
  seen.gravitational = gravitational;
  return seen;
}

/// What the watch says of the second state after the first one; rank 0 alone sees them.
std::string said(StabilityWatch& watch, const Observation& now) {
  return support::error_of([&] { watch.check(support::rank() == 0 ? now : Observation{}, 0.25, MPI_COMM_WORLD); });
}

std::string said_after(const Observation& before, const Observation& now) {
  const Preparation ready = one_body();
  StabilityWatch watch(ready);
  watch.start(support::rank() == 0 ? before : Observation{});
  return said(watch, now);
}

ON_RANKS(1, 3);

TEST(StabilityWatch, AllowsTenTimesTheEnergyThatWasGiven) {
  EXPECT_EQ(said_after(energies(1.0), energies(9.9)), "");
  EXPECT_NE(said_after(energies(1.0), energies(10.1)), "");
}

TEST(StabilityWatch, SaysOnAllRanksWhatWasFoundAndWhatToDo) {
  const std::string text = said_after(energies(1.0), energies(20.0));
  EXPECT_THAT(text, HasSubstr("unstable before 0.25 s"));
  EXPECT_THAT(text, HasSubstr("an energy of 20 J"));
  EXPECT_THAT(text, HasSubstr("gave 1 J"));
  EXPECT_THAT(text, HasSubstr("The step is 0.5 of the largest stable one"));
  EXPECT_THAT(text, HasSubstr("raise time.steps_per_sample above 2"));
}

TEST(StabilityWatch, CountsTheWorkOfLoadsAndOfGravity) {
  EXPECT_EQ(said_after(energies(0.0), energies(9.9, 1.0)), "");
  EXPECT_NE(said_after(energies(0.0), energies(10.1, 1.0)), "");
  EXPECT_EQ(said_after(energies(0.0, 0.0, 5.0), energies(9.9, 0.0, 4.0)), "");  // it fell by 1 J
  EXPECT_NE(said_after(energies(0.0, 0.0, 5.0), energies(10.1, 0.0, 4.0)), "");
}

TEST(StabilityWatch, RemembersTheMostThatWasGiven) {
  const Preparation ready = one_body();
  StabilityWatch watch(ready);
  watch.start(energies(0.0));
  EXPECT_EQ(said(watch, energies(4.0, 5.0)), "");
  EXPECT_EQ(said(watch, energies(40.0, 0.0)), "");  // the loads took all of it back
  EXPECT_NE(said(watch, energies(60.0, 0.0)), "");
}

TEST(StabilityWatch, StopsAMotionThatIsNotFinite) {
  EXPECT_NE(said_after(energies(1.0), energies(std::numeric_limits<double>::quiet_NaN())), "");
  EXPECT_NE(said_after(energies(1.0), energies(std::numeric_limits<double>::infinity())), "");
}

TEST(StabilityWatch, AllowsTheRoundOffOfABodyAtRest) {
  EXPECT_EQ(said_after(energies(0.0), energies(1e-12)), "");
  EXPECT_NE(said_after(energies(0.0), energies(1e-11)), "");
}

TEST(StabilityWatch, GoesOnFromItsArchive) {
  const Preparation ready = one_body();
  StabilityWatch first(ready), second(ready);
  first.start(energies(1.0));
  EXPECT_EQ(said(first, energies(4.0, 5.0)), "");
  support::MemoryArchive archive(MPI_COMM_WORLD);
  first.archive(archive);
  archive.restore();
  second.archive(archive);
  EXPECT_EQ(said(second, energies(59.0)), "");
  EXPECT_NE(said(second, energies(61.0)), "");
}

}  // namespace
}  // namespace idiophone::bodies
