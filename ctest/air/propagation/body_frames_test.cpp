// Two plates move as rigid bodies; their frames are known exactly.

#include "idiophone/air/propagation/body_frames.hpp"

#include <gtest/gtest.h>

#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/scene/scene.hpp"
#include "memory_archive.hpp"
#include "ranks.hpp"
#include "two_plates.hpp"

namespace idiophone::propagation {
namespace {

using namespace support;

class BodyFramesTest : public ::testing::Test {
 protected:
  BodyFramesTest() {
    scene_.audio.rate = 8000;
    for (const std::string& name : surface_.bodies) {
      scene_.bodies.emplace_back().name = name;
    }
    scene_.bodies[0].velocity = velocity;
    scene_.bodies[0].spin = spin;
  }

  /// The first plate flies and turns about the mean of its surface from sample 0 on; the second one rests.
  [[nodiscard]] surface::SurfaceMotion motion(const BodyFrames& frames, std::int64_t sample) const {
    const Vector3 centre = frames.at(surface_.bodies[0], 0).reference;
    const double time = static_cast<double>(sample) / scene_.audio.rate;
    surface::SurfaceMotion motion = at_rest(surface_, 0.0);
    const Eigen::AngleAxisd turn(spin.norm() * time, spin.normalized());
    for (std::size_t v = 0; v < surface_.reference.size(); ++v) {
      if (surface_.vertex_ids[v] < surface_.first_vertex[1]) {
        const Vector3 place = centre + time * velocity + turn * (surface_.reference[v] - centre);
        std::copy_n(place.data(), 3, &motion.position[3 * v]);
      }
    }
    return motion;
  }

  void advance(BodyFrames& frames, std::int64_t begin, std::int64_t end) const {
    for (std::int64_t sample = begin; sample < end; ++sample) {
      if (frames.due(sample)) {
        frames.update(sample, motion(frames, sample));
      }
    }
  }

  /// Of a point carried by the first plate.
  void expect_exact(const BodyFrames& frames, std::int64_t sample, double tolerance) const {
    const Vector3 rest(0.1, -0.3, 0.7);
    const BodyFrames::Carrier carrier = frames.at(surface_.bodies[0], sample);
    const double time = static_cast<double>(sample) / scene_.audio.rate;
    const Eigen::AngleAxisd turn(spin.norm() * time, spin.normalized());
    const Vector3 arm = turn * (rest - carrier.reference);
    const Vector3 place = carrier.reference + time * velocity + arm;
    EXPECT_LT((carrier.position(rest) - place).norm(), tolerance);
    EXPECT_LT((carrier.velocity_at(place) - velocity - spin.cross(arm)).norm(), 300 * tolerance);
    EXPECT_LT((carrier.turn - turn.toRotationMatrix()).norm(), 2 * tolerance);
  }

  const Vector3 velocity = {0.5, -0.2, 1.0};
  const Vector3 spin = {1.0, 3.0, -2.0};
  scene::Scene scene_;
  propagation::AudibleSurface surface_ = two_plates();
};

ON_RANKS(1, 3);

TEST_F(BodyFramesTest, SteadyFlightAndRotationAreExact) {
  BodyFrames frames(scene_, surface_, MPI_COMM_WORLD);
  expect_exact(frames, -5, 1e-6);
  advance(frames, 0, 4000);
  expect_exact(frames, 3999, 2e-6);
  const BodyFrames::Carrier still = frames.at(surface_.bodies[1], 3999);
  EXPECT_LT((still.position(Vector3(1, 2, 3)) - Vector3(1, 2, 3)).norm(), 2e-6);
}

TEST_F(BodyFramesTest, CatchUpWithABlowSmoothly) {
  scene_.bodies[0].velocity = scene_.bodies[0].spin = Vector3::Zero();  // not known before
  BodyFrames frames(scene_, surface_, MPI_COMM_WORLD);
  Vector3 before = frames.at(surface_.bodies[0], 0).centre;
  for (std::int64_t sample = 0; sample < 800; ++sample) {
    advance(frames, sample, sample + 1);
    const Vector3 now = frames.at(surface_.bodies[0], sample).centre;
    EXPECT_LT((now - before).norm(), 4.5 * velocity.norm() / scene_.audio.rate);
    before = now;
  }
  expect_exact(frames, 799, 2e-6);
}

TEST_F(BodyFramesTest, GoOnFromASavedState) {
  BodyFrames frames(scene_, surface_, MPI_COMM_WORLD);
  advance(frames, 0, 1000);
  BodyFrames other(scene_, surface_, MPI_COMM_WORLD);
  support::MemoryArchive archive(MPI_COMM_WORLD);
  frames.archive(archive);
  archive.restore();
  other.archive(archive);
  advance(frames, 1000, 2000);
  advance(other, 1000, 2000);
  for (const std::int64_t sample : {1980, 1999}) {
    EXPECT_EQ(frames.at(surface_.bodies[0], sample).position(velocity),
              other.at(surface_.bodies[0], sample).position(velocity));
  }
}

TEST_F(BodyFramesTest, AnUnknownBodyIsRefused) {
  scene::Listener& listener = scene_.listeners.emplace_back();
  listener.attached = "gong";
  EXPECT_TRUE(BodyFrames::needed(scene_));
  EXPECT_THROW(BodyFrames(scene_, surface_, MPI_COMM_WORLD), deck::DeckError);
}

}  // namespace
}  // namespace idiophone::propagation
