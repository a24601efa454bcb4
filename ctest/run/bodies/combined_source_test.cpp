#include "idiophone/run/bodies/combined_source.hpp"

#include <gmock/gmock.h>

#include "ranks.hpp"
#include "shared_folder.hpp"

namespace idiophone::bodies {
namespace {

using namespace support;
using ::testing::ElementsAre;

/// One triangle on each rank that rises by 1 m in each audio sample. Its pressure is the audio sample.
class RisingTriangles : public Source {
 public:
  RisingTriangles(const std::string& name, std::int64_t first) : Source(triangles(name)), first_(first) {}
  [[nodiscard]] std::int64_t first_sample() const override { return first_; }
  void start(surface::SurfaceMotion& motion) override { give(motion); }
  void advance(surface::SurfaceMotion& motion) override {
    ++advanced_;
    give(motion);
  }
  void archive(parallel::Archive& archive) override { archive.root("triangles/" + surface().bodies[0], advanced_); }

 private:
  static propagation::AudibleSurface triangles(const std::string& name) {
    propagation::AudibleSurface surface;
    surface.triangles = {{0, 1, 2}};
    surface.triangle_ids = {rank()};
    surface.vertex_ids = {3 * rank(), 3 * rank() + 1, 3 * rank() + 2};
    surface.reference = {Vector3(0, 0, 0), Vector3(1, 0, 0), Vector3(0, 1, 0)};
    surface.bodies = {name};
    surface.first_triangle = {0, ranks()};
    surface.first_vertex = {0, 3 * ranks()};
    surface.obstacles.resize(1);
    return surface;
  }
  void give(surface::SurfaceMotion& motion) const {
    const auto height = static_cast<double>(first_ + advanced_);
    motion.pressure.assign(padded(1), 0.0);
    motion.pressure[0] = height;
    motion.position.assign(surface::SurfaceMotion::position_length(3), 0.0);
    for (const int vertex : {0, 1, 2}) {
      motion.position[3 * vertex + 2] = height;
    }
  }

  std::int64_t first_;
  std::int64_t advanced_ = 0;
};

CombinedSource combination() {
  std::vector<std::unique_ptr<Source>> sources;
  sources.push_back(std::make_unique<RisingTriangles>("late", -1));
  sources.push_back(std::make_unique<RisingTriangles>("early", -3));
  return CombinedSource(std::move(sources));
}

ON_RANKS(1, 3);

TEST(CombinedSource, JoinsSurfaces) {
  const CombinedSource source = combination();
  const propagation::AudibleSurface& surface = source.surface();
  EXPECT_THAT(surface.bodies, ElementsAre("late", "early"));
  EXPECT_THAT(surface.triangle_ids, ElementsAre(rank(), ranks() + rank()));
  EXPECT_THAT(surface.first_triangle, ElementsAre(0, ranks(), 2 * ranks()));
  EXPECT_THAT(surface.first_vertex, ElementsAre(0, 3 * ranks(), 6 * ranks()));
  EXPECT_EQ(surface.vertex_ids.at(4), 3 * ranks() + 3 * rank() + 1);
  EXPECT_EQ(surface.triangles.at(1), (mesh::Triangle{3, 4, 5}));
  EXPECT_EQ(surface.reference.size(), 6U);
  EXPECT_EQ(surface.obstacles.size(), 2U);
}

TEST(CombinedSource, KeepsASourceSteadyUntilItsFirstSample) {
  CombinedSource source = combination();
  EXPECT_EQ(source.first_sample(), -3);
  EXPECT_EQ(source.samples_before_archive(), 2);
  surface::SurfaceMotion motion;
  source.start(motion);
  for (std::int64_t sample = -3; sample < 4; ++sample) {
    const auto late = static_cast<double>(std::max<std::int64_t>(sample, -1));
    const auto early = static_cast<double>(sample);
    ASSERT_EQ(motion.pressure.size(), padded(2));
    EXPECT_EQ(motion.pressure[0], late) << sample;
    EXPECT_EQ(motion.pressure[1], early) << sample;
    EXPECT_EQ(motion.position.at(8), late);
    EXPECT_EQ(motion.position.at(9 + 2), early);
    source.advance(motion);
  }
}

TEST(CombinedSource, ArchivesEverySource) {
  CombinedSource source = combination();
  parallel::ArchiveNames names(MPI_COMM_WORLD);
  source.archive(names);
  EXPECT_THAT(names.names(), ElementsAre("source/sample", "triangles/early", "triangles/late"));
}

}  // namespace
}  // namespace idiophone::bodies
