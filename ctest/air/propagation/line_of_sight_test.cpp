#include "idiophone/air/propagation/line_of_sight.hpp"

#include <gtest/gtest.h>

#include "memory_archive.hpp"
#include "ranks.hpp"
#include "two_plates.hpp"

namespace idiophone::propagation {
namespace {

using namespace support;

const std::vector<Vector3> above = {Vector3(0.05, 0.02, 3.0)};
constexpr std::int64_t interval = 4;

class LineOfSightTest : public ::testing::Test {
 protected:
  /// The visibility of each triangle here at an audio sample.
  [[nodiscard]] std::vector<double> seen(const LineOfSight& sight, std::int64_t sample) const {
    radiation::Paths paths;
    paths.gain.assign(padded(surface_.triangles.size()), 1.0);
    sight.fade(sample, 0, 0, paths);
    return {paths.gain.begin(), paths.gain.begin() + static_cast<std::ptrdiff_t>(surface_.triangles.size())};
  }

  /// What is expected where the upper plate is seen in full and the lower one in part.
  [[nodiscard]] std::vector<double> with_lower(double visibility) const {
    std::vector<double> expected;
    for (const Index triangle : surface_.triangle_ids) {
      expected.push_back(triangle < 2 ? visibility : 1.0);
    }
    return expected;
  }

  propagation::AudibleSurface surface_ = two_plates();
  LineOfSight::Options options_{interval, 1, radiation::SelfOcclusion::excluded};
};

ON_RANKS(1, 3);

TEST_F(LineOfSightTest, AnotherBodyHides) {
  LineOfSight sight(surface_, options_, MPI_COMM_WORLD);
  sight.start(at_rest(surface_, 0.0), above);
  EXPECT_EQ(seen(sight, -3), with_lower(0.0));
  EXPECT_EQ(seen(sight, 0), with_lower(0.0));
}

TEST_F(LineOfSightTest, AnUpdateFadesInOneIntervalLater) {
  LineOfSight sight(surface_, options_, MPI_COMM_WORLD);
  sight.start(at_rest(surface_, 0.0), above);
  EXPECT_TRUE(sight.due(0));
  EXPECT_FALSE(sight.due(3));
  EXPECT_FALSE(sight.due(-4));
  sight.update(at_rest(surface_, 5.0), above);  // at sample 0: away
  EXPECT_EQ(seen(sight, 3), with_lower(0.0));
  sight.update(at_rest(surface_, 5.0), above);  // at sample 4
  EXPECT_EQ(seen(sight, 4), with_lower(0.0));
  EXPECT_EQ(seen(sight, 5), with_lower(0.25));
  EXPECT_EQ(seen(sight, 7), with_lower(0.75));
  sight.update(at_rest(surface_, 5.0), above);  // at sample 8
  EXPECT_EQ(seen(sight, 8), with_lower(1.0));
}

TEST_F(LineOfSightTest, GoesOnWhereItWasSaved) {
  LineOfSight sight(surface_, options_, MPI_COMM_WORLD);
  sight.start(at_rest(surface_, 0.0), above);
  sight.update(at_rest(surface_, 5.0), above);
  const parallel::Rows rows(surface_.triangle_ids, surface_.global_triangles(), MPI_COMM_WORLD);
  support::MemoryArchive archive(MPI_COMM_WORLD);
  sight.archive(archive, rows);
  archive.restore();
  LineOfSight restored(surface_, options_, MPI_COMM_WORLD);
  restored.archive(archive, rows);
  for (LineOfSight* each : {&sight, &restored}) {
    each->update(at_rest(surface_, 5.0), above);
    EXPECT_EQ(seen(*each, 6), with_lower(0.5));
  }
}

}  // namespace
}  // namespace idiophone::propagation
