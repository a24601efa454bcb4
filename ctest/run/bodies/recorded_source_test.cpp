// A recorded surface motion comes back, row by row, on any number of ranks.

#include "idiophone/run/bodies/recorded_source.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "idiophone/foundation/deck/location.hpp"
#include "memory_archive.hpp"
#include "ranks.hpp"
#include "recorded.hpp"

namespace idiophone::bodies {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// Of a file in a folder.
RecordedSource source_of(const std::filesystem::path& path, const std::string& name = "bell",
                         RecordedObstacles obstacles = RecordedObstacles::keep,
                         const scene::Radiation& radiation = {}) {
  return {name, results::SurfaceMotionReader(path), radiation, obstacles, MPI_COMM_WORLD};
}

void expect_row(const RecordedSource& source, const surface::SurfaceMotion& motion, std::int64_t row) {
  const auto& surface = source.surface();
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    ASSERT_EQ(motion.pressure[i], recorded_pressure(row, surface.triangle_ids[i])) << row;
  }
  for (std::size_t i = 0; i < surface.vertex_ids.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      ASSERT_EQ(motion.position[3 * i + axis], recorded_position(row, surface.vertex_ids[i], axis)) << row;
    }
  }
}

ON_RANKS(1, 3);

TEST(RecordedSource, GivesEveryRowOfItsShare) {
  const support::Folder folder;
  record_surface(folder / "bell_surface.h5");
  RecordedSource source = source_of(folder / "bell_surface.h5");
  EXPECT_EQ(source.first_sample(), -2);
  EXPECT_EQ(source.samples(), recorded_rows - 1);
  surface::SurfaceMotion motion;
  source.start(motion);
  for (std::int64_t row = 0; row < recorded_rows; ++row) {
    expect_row(source, motion, row);
    source.advance(motion);
  }
  EXPECT_NO_THROW(source.check());
}

TEST(RecordedSource, DividesTrianglesAmongTheRanksAndGivesEachTheirCorners) {
  const support::Folder folder;
  record_surface(folder / "bell_surface.h5");
  const RecordedSource source = source_of(folder / "bell_surface.h5");
  const auto& surface = source.surface();
  auto triangles = static_cast<int>(surface.triangles.size());
  MPI_Allreduce(MPI_IN_PLACE, &triangles, 1, MPI_INT, MPI_SUM, MPI_COMM_WORLD);
  EXPECT_EQ(triangles, recorded_triangles);
  EXPECT_GE(surface.triangles.size(), static_cast<std::size_t>(recorded_triangles / support::ranks()));
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    const std::int32_t first = surface.triangle_ids[i] < 4 ? surface.triangle_ids[i] % 3 : 6;
    EXPECT_EQ(surface.vertex_ids.at(surface.triangles[i][0]), first);
    EXPECT_NEAR(surface.reference.at(surface.triangles[i][0]).x(), 0.1 * first, 1e-15);
  }
  EXPECT_THAT(surface.first_triangle, ElementsAre(0, 4, 7));
  EXPECT_THAT(surface.first_vertex, ElementsAre(0, 6, 9));
}

TEST(RecordedSource, StaysStillAndSilentAfterItsLastRow) {
  const support::Folder folder;
  record_surface(folder / "bell_surface.h5");
  RecordedSource source = source_of(folder / "bell_surface.h5");
  surface::SurfaceMotion motion;
  source.start(motion);
  for (int sample = 0; sample < 9; ++sample) {
    source.advance(motion);
  }
  const auto& surface = source.surface();
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    EXPECT_EQ(motion.pressure[i], 0.0);
  }
  for (std::size_t i = 0; i < surface.vertex_ids.size(); ++i) {
    EXPECT_EQ(motion.position[3 * i], recorded_position(recorded_rows - 1, surface.vertex_ids[i], 0));
  }
}

TEST(RecordedSource, GoesOnFromItsArchive) {
  const support::Folder folder;
  record_surface(folder / "bell_surface.h5");
  RecordedSource straight = source_of(folder / "bell_surface.h5"), resumed = source_of(folder / "bell_surface.h5");
  surface::SurfaceMotion motion;
  straight.start(motion);
  straight.advance(motion);
  straight.advance(motion);
  support::MemoryArchive archive(MPI_COMM_WORLD);
  straight.archive(archive);
  archive.restore();
  resumed.archive(archive);
  resumed.advance(motion);
  expect_row(resumed, motion, 3);
}

TEST(RecordedSource, NamesItsBodiesByTheRecordingAndThemselves) {
  const support::Folder folder;
  record_surface(folder / "two_surface.h5");
  auto header = recorded_header();
  header.bodies = {{"plate", 0, 0}};
  record_surface(folder / "one_surface.h5", header);
  EXPECT_THAT(source_of(folder / "two_surface.h5").surface().bodies, ElementsAre("bell_plate", "bell_hammer"));
  EXPECT_THAT(source_of(folder / "two_surface.h5", "").surface().bodies, ElementsAre("plate", "hammer"));
  EXPECT_THAT(source_of(folder / "one_surface.h5").surface().bodies, ElementsAre("bell"));
}

TEST(RecordedSource, KeepsItsObstaclesOrLeavesThemOut) {
  const support::Folder folder;
  record_surface(folder / "bell_surface.h5");
  const RecordedSource kept = source_of(folder / "bell_surface.h5");
  ASSERT_THAT(kept.surface().obstacles, SizeIs(1));
  EXPECT_EQ(kept.surface().obstacles[0][1], Vector3(1, 0, 0));
  ASSERT_THAT(kept.surface().half_spaces, SizeIs(1));
  const RecordedSource left_out = source_of(folder / "bell_surface.h5", "bell", RecordedObstacles::leave_out);
  EXPECT_THAT(left_out.surface().obstacles, IsEmpty());
  EXPECT_THAT(left_out.surface().half_spaces, IsEmpty());
}

TEST(RecordedSource, HasRadiiWhereRadiationAsksForThem) {
  const support::Folder folder;
  record_surface(folder / "bell_surface.h5");
  scene::Radiation radiation;
  for (const auto model : {scene::RadiationModel::rayleigh, scene::RadiationModel::kirchhoff}) {
    radiation.model = model;
    const RecordedSource source = source_of(folder / "bell_surface.h5", "bell", RecordedObstacles::keep, radiation);
    EXPECT_THAT(source.surface().radii, SizeIs(radiation.needs_radii() ? source.surface().triangles.size() : 0U));
  }
}

/// A scene with one recording, said in line 3 of its deck.
scene::Scene scene_with(const std::filesystem::path& path) {
  scene::Scene scene;
  scene.audio.rate = 8000;
  scene.radiation.air.density = 1.2;
  scene.radiation.air.speed = 340;
  scene.recorded_bodies = {{.name = "bell", .recording = path, .where = {"deck.yaml", 3, 5}}};
  return scene;
}

std::string refusal(const scene::Scene& scene) {
  return support::error_of([&] { check_recordings(scene); });
}

ON_RANKS(1);

TEST(Recordings, HaveTheRateAndTheAirOfTheScene) {
  const support::Folder folder;
  record_surface(folder / "bell_surface.h5");
  scene::Scene scene = scene_with(folder / "bell_surface.h5");
  EXPECT_EQ(refusal(scene), "");
  scene.audio.rate = 44100;
  EXPECT_EQ(refusal(scene),
            "deck.yaml:3:5: bodies.bell.recording: it has 8000 audio samples per second, audio.rate is 44100");
  scene.audio.rate = 8000;
  scene.radiation.air.speed = 343;
  EXPECT_EQ(refusal(scene),
            "deck.yaml:3:5: bodies.bell.recording: its air has 1.2 kg/m3 and 340 m/s, radiation.air has 1.2 kg/m3 and "
            "343 m/s");
}

TEST(Recordings, AreThereAndIntact) {
  const support::Folder folder;
  EXPECT_THAT(refusal(scene_with(folder / "nothing.h5")), HasSubstr("deck.yaml:3:5: bodies.bell.recording: "));
  record_surface(folder / "bell_surface.h5");
  std::filesystem::resize_file(folder / "bell_surface.h5", 4000);
  EXPECT_THAT(refusal(scene_with(folder / "bell_surface.h5")), HasSubstr("deck.yaml:3:5: bodies.bell.recording: "));
}

TEST(Recordings, AreToldApartByTheirContents) {
  const support::Folder folder;
  record_surface(folder / "one.h5");
  record_surface(folder / "same.h5");
  record_surface(folder / "other.h5", recorded_header(), 1.5);
  EXPECT_EQ(fingerprint(scene_with(folder / "one.h5")), fingerprint(scene_with(folder / "same.h5")));
  EXPECT_NE(fingerprint(scene_with(folder / "one.h5")), fingerprint(scene_with(folder / "other.h5")));
  EXPECT_EQ(fingerprint({}), "");
}

}  // namespace
}  // namespace idiophone::bodies
