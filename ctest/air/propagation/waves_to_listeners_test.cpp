// From waves on a grid to listeners, also where an accelerator computes the waves: what is heard arrives an audio
// sample late.

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>

#include "idiophone/air/propagation/audio_path.hpp"
#include "idiophone/air/propagation/wave_plan.hpp"
#include "idiophone/air/waves/division.hpp"
#include "pulsating_cube.hpp"
#include "ranks.hpp"

namespace idiophone::propagation {
namespace {

using namespace support;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

const Vector3 inside(0.03, 0.031, -0.029), outside(0.6, -0.5, 0.4);  // of the box

class WavesToListeners : public PulsatingCube {
 protected:
  /// Null if there is none.
  static std::unique_ptr<accelerator::Accelerator> find_accelerator() {
    try {
      return std::make_unique<accelerator::Accelerator>("0");
    } catch (const std::runtime_error&) {
      return nullptr;
    }
  }

  /// Within the box, away from the cube.
  void listen_on_the_way() {
    scene_.radiation.grid.margin = 0.02;
    listen_at(inside).path = scene::Path{.points = {{0.0, inside}, {0.006, 1.4 * inside}}, .where = {}};
  }

  [[nodiscard]] std::vector<std::vector<double>> hear_in_blocks(accelerator::Accelerator* accelerator) const {
    const auto surface = cube(rank(), ranks());
    WaveAir air(scene_, surface, steady_sample, stages(), MPI_COMM_WORLD, accelerator);
    air.start(steady_sample, motion(surface, 0.0));
    std::vector<std::vector<double>> heard(scene_.listeners.size());
    std::int64_t begin = steady_sample + 1, taken = 0;
    for (std::int64_t block = 1; taken < static_cast<std::int64_t>(heard_samples); ++block) {
      propagate(air, surface, begin, begin + block, 1.0);
      begin += block;
      air.finish();
      const auto count = std::min<std::int64_t>(air.final_before(begin - 1), heard_samples) - taken;
      const auto sounds = count > 0 ? air.take(count) : std::vector<std::vector<double>>();
      taken += std::max<std::int64_t>(0, count);
      for (std::size_t ear = 0; ear < sounds.size(); ++ear) {
        heard[ear].insert(heard[ear].end(), sounds[ear].begin(), sounds[ear].end());
      }
    }
    return heard;
  }

  /// How many ranks have cells around a place. Collective.
  [[nodiscard]] int ranks_around(const Vector3& place, const AudibleSurface& surface) const {
    const waves::Plan plan = wave_plan(scene_, surface, MPI_COMM_WORLD);
    const waves::Division division(plan.grid, ranks());
    const std::array<int, 3> first = waves::cell_at(plan.grid.in_cells(place) - Vector3::Constant(0.5));
    const waves::CellBox around{.from = first, .to = {first[0] + 2, first[1] + 2, first[2] + 2}};
    int count = 0;
    for (int rank = 0; rank < ranks(); ++rank) {
      count += common(around, division.cells(rank)).is_empty() ? 0 : 1;
    }
    return count;
  }

  /// So many audio samples of a pressure at the cube, which is so far from its place.
  void hear(AudioPath& path, const AudibleSurface& surface, int count, double emitted, double shift = 0.0) const {
    surface::SurfaceMotion now = motion(surface, shift);
    std::fill_n(now.pressure.begin(), surface.triangles.size(), emitted);
    for (int sample = 0; sample < count; ++sample) {
      path.hear(now);
    }
  }
};

ON_RANKS(1, 3);

TEST_F(WavesToListeners, AreHeardWhereAListenerMovesWithinTheBox) {
  listen_on_the_way();
  const auto heard = PulsatingCube::hear(MPI_COMM_WORLD);
  if (rank() == 0) {
    EXPECT_LT(error(heard.at(0),
                    [&](double sample) {
                      const scene::Listener& listener = scene_.listeners.front();
                      return exact(listener.path->at(sample / scene_.audio.rate).position.norm(), sample);
                    }),
              0.1);
  }
}

TEST_F(WavesToListeners, AreHeardAlikeInBlocksAndFromAnAccelerator) {
  listen_at(outside);
  listen_at(inside);
  listen_on_the_way();
  const auto expected = PulsatingCube::hear(MPI_COMM_WORLD, 1.0), blocks = hear_in_blocks(nullptr);
  const auto accelerator = find_accelerator();
  const auto there = accelerator ? hear_in_blocks(accelerator.get()) : blocks;
  if (rank() == 0) {
    EXPECT_EQ(blocks, expected);
    ASSERT_EQ(there.size(), 3);
    for (std::size_t ear = 0; ear < there.size(); ++ear) {
      EXPECT_LT(error(there[ear], [&](double sample) { return expected[ear].at(static_cast<std::size_t>(sample)); }),
                1e-5);  // NaN if nothing is heard
    }
  }
}

TEST_F(WavesToListeners, TellTheProblemOfTheLastAudioSample) {
  listen_at(inside);
  const auto surface = cube(rank(), ranks());
  AudioPath path(scene_, surface, steady_sample, stages(), MPI_COMM_WORLD);
  path.start(motion(surface, 0.0));
  hear(path, surface, 12, 1.0);
  path.check();
  hear(path, surface, 1, std::numeric_limits<double>::quiet_NaN());
  path.check();  // it reaches the grid in the next audio sample
  hear(path, surface, 1, 0.0);
  EXPECT_THAT(error_of([&] { path.check(); }), HasSubstr("is not finite"));
}

TEST_F(WavesToListeners, TellAProblemOfOneRankNotBeforeTheCheck) {
  const auto surface = cube(rank(), ranks());
  listen_at(inside);
  ASSERT_EQ(ranks_around(inside, surface), 1);
  AudioPath path(scene_, surface, steady_sample, stages(), MPI_COMM_WORLD);
  path.start(motion(surface, 0.0));
  constexpr double too_loud = 1e25;
  for (int sample = 0; sample < 40; ++sample) {
    hear(path, surface, 1, too_loud);
    hear(path, surface, 1, -too_loud);
  }
  constexpr auto no_limit = std::numeric_limits<std::int64_t>::max();
  EXPECT_EQ(path.take(no_limit).size(), 1);
  EXPECT_THAT(error_of([&] { path.check(); }), HasSubstr("or above"));
}

ON_RANKS(1);

TEST_F(WavesToListeners, TellTheFirstOfTheirProblems) {
  listen_at(inside);
  const auto surface = cube(rank(), ranks());
  AudioPath path(scene_, surface, steady_sample, stages(), MPI_COMM_WORLD);
  path.start(motion(surface, 0.0));
  hear(path, surface, 4, std::numeric_limits<double>::quiet_NaN());
  hear(path, surface, 12, 0.0, 1.0);
  EXPECT_THAT(error_of([&] { path.check(); }), AllOf(HasSubstr("is not finite"), Not(HasSubstr("leaves the grid"))));
}

TEST_F(WavesToListeners, TellAProblemThatIsOnTheWayBeforeALaterOne) {
  listen_at(inside);
  const auto surface = cube(rank(), ranks());
  AudioPath path(scene_, surface, steady_sample, stages(), MPI_COMM_WORLD);
  path.start(motion(surface, 0.0));
  hear(path, surface, 8, 0.0);  // up to the audio sample 6
  hear(path, surface, 1, std::numeric_limits<double>::quiet_NaN());
  hear(path, surface, 1, 0.0, 1.0);  // 8, in which the grid takes notice of motion
  path.hear(motion(surface, 1.0));
  EXPECT_THAT(error_of([&] { path.check(); }), AllOf(HasSubstr("is not finite"), Not(HasSubstr("leaves the grid"))));
}

}  // namespace
}  // namespace idiophone::propagation
