// Waves on an accelerator are those of the processor. Any OpenCL device will do; pocl-opencl-icd is one without
// hardware.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "memory_archive.hpp"
#include "pulsating.hpp"
#include "ranks.hpp"
#include "shared_folder.hpp"

namespace idiophone::waves {
namespace {

/// Over the largest pressure: rounding after some fifty steps. 0.01 dB would be 1e-3.
constexpr float rounding = 1e-5F;

std::vector<Index> cells_of(const WaveField& field) {
  std::vector<Index> cells;
  for_each_cell(field.subdomain().cells(),
                [&](const std::array<int, 3>& cell) { cells.push_back(field.subdomain().number(cell)); });
  return cells;
}

std::vector<float> pressures(const WaveField& field) {
  const auto probe = field.probe(cells_of(field));
  const std::span<const float> values = probe->read();
  return {values.begin(), values.end()};
}

/// Largest difference over the largest value.
float difference(const std::vector<float>& values, const std::vector<float>& reference) {
  float largest = 0.0F, wrong = 0.0F;
  for (std::size_t i = 0; i < reference.size(); ++i) {
    largest = std::max(largest, std::abs(reference[i]));
    wrong = std::max(wrong, std::abs(values[i] - reference[i]));
  }
  return wrong / largest;
}

class WavesOnAccelerator : public testing::TestWithParam<Setting> {
 protected:
  void SetUp() override {
    try {
      accelerator_ = std::make_unique<accelerator::Accelerator>("0");
    } catch (const std::runtime_error& error) {
      GTEST_SKIP() << error.what();
    }
  }
  [[nodiscard]] Pulsating on_processor() const { return {GetParam(), support::ranks(), MPI_COMM_WORLD}; }
  [[nodiscard]] Pulsating on_accelerator() const {
    return {GetParam(), support::ranks(), MPI_COMM_WORLD, accelerator_.get()};
  }

  std::unique_ptr<accelerator::Accelerator> accelerator_;
};
// With losses in an absorbing layer all around, and on a floor.
INSTANTIATE_TEST_SUITE_P(, WavesOnAccelerator, testing::Values(settings().at(2), settings().at(3)));

class WavesOnAcceleratorAndFloor : public WavesOnAccelerator {};
INSTANTIATE_TEST_SUITE_P(, WavesOnAcceleratorAndFloor, testing::Values(settings().at(3)));

ON_RANKS(1, 3);

TEST_P(WavesOnAcceleratorAndFloor, FillSpaceThatOpensAtTheFloor) {
  Pulsating here = on_processor(), there = on_accelerator();
  const double floor = GetParam().grid.corner[2], radius = GetParam().radius, cell = GetParam().grid.cell;
  for (Pulsating* one : {&here, &there}) {
    one->set(Vector3(0.0, 0.0, floor + 0.6 * cell - radius));  // the lower part of cells is solid
    one->advance(25);
    one->set(Vector3(0.0, 0.0, floor + 0.3 * cell + radius));  // the upper part of the same cells
  }
  EXPECT_LT(difference(pressures(there.field()), pressures(here.field())), rounding);
}

TEST_P(WavesOnAccelerator, AreThoseOfTheProcessorWhateverMoves) {
  Pulsating here = on_processor(), there = on_accelerator();
  for (const double shift : {0.0, 0.0087}) {
    for (Pulsating* one : {&here, &there}) {
      one->set(Vector3(shift, -shift, shift));
      one->advance(25);
    }
    EXPECT_LT(difference(pressures(there.field()), pressures(here.field())), rounding);
  }
}

TEST_P(WavesOnAccelerator, TakeVelocitiesThatAreKnownAtTheAudioRate) {
  Pulsating here = on_processor(), there = on_accelerator();
  for (const double shift : {0.0, 0.0087}) {
    for (Pulsating* one : {&here, &there}) {
      one->set(Vector3(shift, -shift, shift));
      one->advance_samples(20);  // more than are kept
    }
    EXPECT_LT(difference(pressures(there.field()), pressures(here.field())), rounding);
  }
}

TEST_P(WavesOnAccelerator, ForecastThePressuresOfTheProcessor) {
  Pulsating here = on_processor(), there = on_accelerator();
  std::vector<float> expected(here.field().cut_cells().nodes().size()), forecast(expected.size());
  for (int step = 0; step < 25; ++step) {  // a forecast changes nothing
    here.advance(1);
    here.field().forecast(expected);
    there.advance(1);
    there.field().forecast(forecast);
  }
  if (here.field().cut_cells().own_nodes() > 0) {
    EXPECT_LT(difference(forecast, expected), rounding);
  }
}

TEST_P(WavesOnAccelerator, ShowThePressuresThatAProbeTookWhileStepsGoOn) {
  Pulsating here = on_processor(), there = on_accelerator();
  for (Pulsating* one : {&here, &there}) {
    one->advance(25);
    const std::vector<float> expected = pressures(one->field());
    const auto probe = one->field().probe(cells_of(one->field()));
    for (int round = 0; round < 2; ++round) {
      probe->begin();
      one->set(Vector3(0.0087 * round, 0.0, 0.0));
      one->advance(3);
      const std::span<const float> found = probe->finish();
      EXPECT_EQ(std::ranges::equal(found, expected), round == 0);
    }
  }
}

TEST_P(WavesOnAccelerator, ShowOtherCellsToAProbe) {
  Pulsating one = on_accelerator();
  one.advance(25);
  const std::vector<Index> cells = cells_of(one.field());
  const std::vector<float> all = pressures(one.field());
  const auto probe = one.field().probe(cells);
  for (const std::size_t count : {std::size_t{5}, std::size_t{0}, cells.size() / 2}) {
    const auto last = std::span(cells).last(count);
    probe->set_cells(last);
    EXPECT_TRUE(std::ranges::equal(probe->read(), std::span(all).last(count))) << count;
  }
}

TEST_P(WavesOnAccelerator, GoOnFromAnArchiveOfTheProcessorAndTheReverse) {
  Pulsating processor = on_processor(), accelerator = on_accelerator();
  for (Pulsating* saved : {&processor, &accelerator}) {
    Pulsating resumed = saved == &processor ? on_accelerator() : on_processor();
    saved->advance(25);
    support::MemoryArchive archive(MPI_COMM_WORLD);
    saved->field().archive(archive);
    resumed.advance(25);           // to the same moment of the pulse
    for (int i = 0; i < 3; ++i) {  // all of its state differs
      resumed.field().step(std::vector<float>(resumed.field().cut_cells().nodes().size()));
    }
    archive.restore();
    resumed.field().archive(archive);
    saved->advance(25);
    resumed.advance(25);
    EXPECT_LT(difference(pressures(resumed.field()), pressures(saved->field())), rounding);
  }
}

TEST_P(WavesOnAccelerator, HaveTheSameBitsOnAnyRanks) {
  Pulsating whole(GetParam(), 1, MPI_COMM_SELF, accelerator_.get());
  Pulsating part = on_accelerator();
  for (Pulsating* one : {&whole, &part}) {
    one->advance(40);
  }
  std::vector<Index> cells;
  for_each_cell(part.field().subdomain().cells(),
                [&](const std::array<int, 3>& cell) { cells.push_back(whole.field().subdomain().number(cell)); });
  const auto probe = whole.field().probe(std::move(cells));
  const std::span<const float> expected = probe->read();
  EXPECT_EQ(pressures(part.field()), std::vector<float>(expected.begin(), expected.end()));
}

}  // namespace
}  // namespace idiophone::waves
