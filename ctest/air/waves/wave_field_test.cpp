#include "idiophone/air/waves/wave_field.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "memory_archive.hpp"
#include "pulsating.hpp"
#include "ranks.hpp"
#include "shared_folder.hpp"

namespace idiophone::waves {
namespace {

void expect_same(const WaveField& part, const WaveField& whole) {
  for_each_cell(part.subdomain().cells(), [&](const std::array<int, 3>& cell) {
    ASSERT_EQ(part.pressure(part.subdomain().number(cell)), whole.pressure(whole.subdomain().number(cell)))
        << cell[0] << ' ' << cell[1] << ' ' << cell[2];
  });
}

ON_RANKS(1, 3, 8);

class DividedWaveField : public testing::TestWithParam<Setting> {};
INSTANTIATE_TEST_SUITE_P(, DividedWaveField, testing::ValuesIn(settings()));

TEST_P(DividedWaveField, HasTheSameBitsOnAnyRanksWhateverMoves) {
  Pulsating whole(GetParam(), 1, MPI_COMM_SELF);
  Pulsating part(GetParam(), support::ranks(), MPI_COMM_WORLD);
  for (const double shift : {0.0, 0.0031, 0.0087, -0.02}) {
    for (Pulsating* one : {&whole, &part}) {
      one->set(Vector3(shift, -shift, shift));
      one->advance(30);
    }
    expect_same(part.field(), whole.field());
  }
  EXPECT_NE(part.field().pressure(part.field().subdomain().number(part.field().subdomain().cells().from)), 0.0F);
}

ON_RANKS(1, 3);

TEST_P(DividedWaveField, GoesOnFromAnArchive) {
  Pulsating first(GetParam(), support::ranks(), MPI_COMM_WORLD);
  first.advance(40);
  support::MemoryArchive archive(MPI_COMM_WORLD);
  first.field().archive(archive);
  Pulsating second(GetParam(), support::ranks(), MPI_COMM_WORLD);
  second.advance(40);             // to the same moment of the pulse
  for (int i = 0; i < 10; ++i) {  // all of its state differs
    second.field().step(std::vector<float>(second.field().cut_cells().nodes().size()));
  }
  archive.restore();
  second.field().archive(archive);
  first.advance(40);
  second.advance(40);
  expect_same(second.field(), first.field());
}

/// A point of the open field that a pulse passes.
std::vector<float> heard(const Grid& grid, std::array<int, 3> source, std::array<int, 3> receiver, int steps) {
  WaveField field(Division(grid, 1), test_courant, MPI_COMM_SELF);
  std::vector<float> sound;
  const Index at = field.subdomain().number(source);
  for (int i = 0; i < steps; ++i) {
    const double x = (i - 40.0) / 10.0;
    field.set_pressure(at, field.pressure(at) + static_cast<float>(-x * std::exp(-0.5 * x * x)));
    field.step({});
    sound.push_back(field.pressure(field.subdomain().number(receiver)));
  }
  return sound;
}

ON_RANKS(1);

TEST(WaveField, ReflectsLittleFromItsLayer) {
  // The same pulse in a grid so large that no reflection comes back in time.
  constexpr int steps = 150, more = 40;
  const auto near = heard(grid_of({48, 48, 48}, 10), {16, 24, 24}, {14, 33, 26}, steps);
  const auto far = heard(grid_of({48 + 2 * more, 48 + 2 * more, 48 + 2 * more}, 10), {16 + more, 24 + more, 24 + more},
                         {14 + more, 33 + more, 26 + more}, steps);
  float loudest = 0.0F, reflected = 0.0F;
  for (int i = 0; i < steps; ++i) {
    loudest = std::max(loudest, std::abs(far[i]));
    reflected = std::max(reflected, std::abs(near[i] - far[i]));
  }
  EXPECT_GT(loudest, 0.0F);
  EXPECT_LT(20.0 * std::log10(reflected / loudest), -50.0);
}

TEST(WaveField, IsMirroredByARigidFloor) {
  Grid half = grid_of({32, 32, 16}, 6);
  half.rigid_below = true;
  const Grid whole = grid_of({32, 32, 32}, 6);
  const auto above = heard(half, {14, 16, 2}, {18, 17, 5}, 80);
  const auto both = heard(whole, {14, 16, 18}, {18, 17, 21}, 80);
  const auto image = heard(whole, {14, 16, 13}, {18, 17, 21}, 80);
  for (std::size_t i = 0; i < above.size(); ++i) {
    ASSERT_NEAR(above[i], both[i] + image[i], 1e-5);
  }
}

}  // namespace
}  // namespace idiophone::waves
