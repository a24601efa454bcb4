// A cube that pulsates on a grid: where it is small compared with the waves, p = S P'(t - R/c)/(4 pi R c), with its
// surface S and P = z v.

#include "wave_air.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "checkpointed.hpp"
#include "pulsating_cube.hpp"
#include "ranks.hpp"

namespace idiophone::propagation {
namespace {

using namespace support;
using ::testing::HasSubstr;

class WaveAirTest : public PulsatingCube {};

ON_RANKS(1, 3);

TEST_F(WaveAirTest, IsHeardOutsideTheGridAndInside) {
  listen_at(Vector3(0.6, -0.5, 0.4));
  listen_at(Vector3(0.03, 0.031, -0.029));
  const auto heard = hear(MPI_COMM_WORLD);
  if (rank() == 0) {
    EXPECT_LT(error(heard.at(0), [&](double sample) { return exact(std::sqrt(0.77), sample); }), 0.04);
    EXPECT_LT(error(heard.at(1), [&](double sample) { return exact(0.052, sample); }), 0.1);
  }
}

TEST_F(WaveAirTest, ReflectsFromTheFloor) {
  scene_.radiation.floor = {.at = Vector3(0, 0, -0.05), .direction = Vector3::UnitZ(), .reflection = 1.0};
  listen_at(Vector3(0.8, 0.0, -0.05));
  const auto heard = hear(MPI_COMM_WORLD);
  if (rank() == 0) {
    EXPECT_LT(error(heard.at(0), [&](double sample) { return 2.0 * exact(std::hypot(0.8, 0.05), sample); }), 0.05);
  }
}

TEST_F(WaveAirTest, HasTheSameBitsOnAnyRanksAndFromAnArchive) {
  scene_.radiation.grid.margin = 0.02;
  listen_at(Vector3(0.6, -0.5, 0.4));
  constexpr double speed = 1.5;  // m/s
  const auto alone = hear(MPI_COMM_SELF, speed);
  const auto together = hear(MPI_COMM_WORLD, speed);

  const Folder folder;
  const auto surface = cube(rank(), ranks());
  const auto make = [&] { return WaveAir(scene_, surface, steady_sample, stages(), MPI_COMM_WORLD); };
  WaveAir air = make();
  air.start(steady_sample, motion(surface, 0.0));
  propagate(air, surface, steady_sample + 1, 33, speed);
  air.finish();
  const auto checkpoint = save(folder, air);
  WaveAir resumed = make();
  restore(checkpoint, MPI_COMM_WORLD, resumed);
  propagate(resumed, surface, 33, heard_samples - resumed.final_before(0) + 1, speed);
  resumed.finish();
  const auto rest = resumed.take(heard_samples);
  if (rank() == 0) {
    EXPECT_EQ(together, alone);
    EXPECT_EQ(rest, alone);
  }
}

TEST_F(WaveAirTest, SoundsTheSameWhileTheBodyMoves) {
  scene_.radiation.grid.margin = 0.02;
  listen_at(Vector3(0.0, 0.0, 0.8));
  const auto at_rest = hear(MPI_COMM_WORLD);
  const auto moving = hear(MPI_COMM_WORLD, 1.5);
  if (rank() == 0) {
    EXPECT_LT(error(moving.at(0), [&](double sample) { return at_rest.at(0)[static_cast<std::size_t>(sample)]; }),
              0.02);
  }
}

TEST_F(WaveAirTest, RefusesABodyThatLeavesTheGrid) {
  listen_at(Vector3(0.6, -0.5, 0.4));
  EXPECT_THAT(error_of([&] { static_cast<void>(hear(MPI_COMM_WORLD, 20.0)); }), HasSubstr("a body leaves the grid"));
}

}  // namespace
}  // namespace idiophone::propagation
