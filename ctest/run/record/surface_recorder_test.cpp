#include "idiophone/run/record/surface_recorder.hpp"

#include <gmock/gmock.h>

#include "checkpointed.hpp"
#include "idiophone/run/results/surface_motion_reader.hpp"
#include "ranks.hpp"
#include "two_plates.hpp"

namespace idiophone::record {
namespace {

using namespace support;
using ::testing::ElementsAre;

constexpr std::int64_t steady_sample = -3;
constexpr std::int64_t samples = 50;

/// Pressure of a triangle at an audio sample, Pa.
double pressure_of(std::int64_t sample, Index triangle) {
  return static_cast<double>(100 * sample + triangle) / 3.0;
}

class SurfaceRecorderTest : public ::testing::Test {
 protected:
  SurfaceRecorderTest() {
    scene_.name = "plates";
    scene_.deck_text = "name: plates\n";
    scene_.audio.rate = 8000;
    scene_.radiation.air = {.density = 1.3, .speed = 330};
    surface_.obstacles = {{Vector3(1, 2, 3), Vector3(4, 5, 6), Vector3(7, 8, 9)}};
  }

  [[nodiscard]] SurfaceRecorder make_recorder() const {
    return {scene_, surface_, steady_sample, samples, path_, MPI_COMM_WORLD};
  }

  /// The upper plate is shifted by a metre in each audio sample.
  void note(SurfaceRecorder& recorder, std::int64_t begin, std::int64_t end) const {
    for (std::int64_t sample = begin; sample < end; ++sample) {
      surface::SurfaceMotion motion = at_rest(surface_, static_cast<double>(sample));
      for (std::size_t i = 0; i < surface_.triangles.size(); ++i) {
        motion.pressure[i] = pressure_of(sample, surface_.triangle_ids[i]);
      }
      recorder.note(sample, motion);
    }
    recorder.write();
    barrier();
  }

  /// Expects rows for these audio samples, from the steady motion on.
  void expect_rows(const std::vector<std::int64_t>& noted) const {
    const results::SurfaceMotionReader reader(path_);
    ASSERT_EQ(reader.rows(), std::ssize(noted));
    for (std::size_t row = 0; row < noted.size(); ++row) {
      const auto at = static_cast<std::int64_t>(row);
      const std::int64_t sample = noted[row];
      EXPECT_THAT(reader.read_pressure(at, 1, 0, 4), ElementsAre(pressure_of(sample, 0), pressure_of(sample, 1),
                                                                 pressure_of(sample, 2), pressure_of(sample, 3)));
      const auto shift = static_cast<double>(sample);
      EXPECT_THAT(reader.read_position(at, 1, 3, 2), ElementsAre(0.5, 0.5, 0, -0.5 + shift, -0.5, 1));
    }
  }

  Folder folder_;
  std::filesystem::path path_ = folder_ / "plates_surface.h5";
  scene::Scene scene_;
  propagation::AudibleSurface surface_ = two_plates();
};

ON_RANKS(1, 3);

TEST_F(SurfaceRecorderTest, WritesTheSurfaceAndItsMotion) {
  SurfaceRecorder recorder = make_recorder();
  recorder.declare();
  note(recorder, -3, -1);
  note(recorder, -1, 2);
  expect_rows({-3, -2, -1, 0, 1});
  const results::SurfaceMotionReader reader(path_);
  const surface::RecordingHeader& header = reader.header();
  EXPECT_EQ(header.origin.name, "plates");
  EXPECT_EQ(header.origin.deck_text, "name: plates\n");
  EXPECT_EQ(header.rate, 8000);
  EXPECT_EQ(header.first_sample, steady_sample);
  EXPECT_EQ(header.samples, samples);
  EXPECT_EQ(header.air_density, 1.3);
  EXPECT_EQ(header.air_speed, 330);
  ASSERT_EQ(header.bodies.size(), 2U);
  EXPECT_EQ(header.bodies[1].name, "upper");
  EXPECT_EQ(header.bodies[1].first_triangle, 2);
  EXPECT_EQ(header.bodies[1].first_vertex, 4);
  EXPECT_THAT(header.obstacle_triangles, ElementsAre(1, 2, 3, 4, 5, 6, 7, 8, 9));
  EXPECT_THAT(reader.read_triangles(2, 2), ElementsAre(std::array{4, 5, 6}, std::array{5, 7, 6}));
  EXPECT_THAT(reader.read_reference(7, 1), ElementsAre(0.5, 0.5, 1));
}

TEST_F(SurfaceRecorderTest, IsCutBackToWhatItsArchiveKnows) {
  std::filesystem::path checkpoint;
  {
    SurfaceRecorder recorder = make_recorder();
    recorder.declare();
    note(recorder, -3, 0);
    checkpoint = save(folder_, recorder);
    note(recorder, 0, 7);
  }
  SurfaceRecorder resumed = make_recorder();
  restore(checkpoint, MPI_COMM_WORLD, resumed);
  note(resumed, 20, 22);
  expect_rows({-3, -2, -1, 20, 21});
}

TEST_F(SurfaceRecorderTest, NotesAsManySamplesAsFitIntoMemory) {
  const std::int64_t longest = make_recorder().longest_block();
  const int numbers = (4 + ranks() - 1) / ranks() + 3 * 8;  // on the fullest rank
  EXPECT_EQ(longest, (64 << 20) / (8 * numbers));
}

TEST(RecordingOf, IsBesideTheResult) {
  EXPECT_EQ(recording_of("results/plates.h5"), "results/plates_surface.h5");
}

}  // namespace
}  // namespace idiophone::record
