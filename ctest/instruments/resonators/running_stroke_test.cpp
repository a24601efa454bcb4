#include "idiophone/instruments/resonators/running_stroke.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <span>
#include <vector>

#include "idiophone/instruments/resonators/force.hpp"
#include "rate.hpp"

namespace idiophone::resonators {

namespace {

score::Stroke slow_scrape(double roughness) {
  score::Stroke stroke;
  stroke.from = {0.0, 0.0, 0.0};
  stroke.to = {0.1, 0.0, 0.0};
  stroke.direction = -Vector3::UnitZ();
  stroke.speed = 0.2;
  stroke.load = 2.0;
  stroke.mass = 0.02;
  stroke.hardness = 1e9;
  stroke.friction = 0.5;
  stroke.roughness.height = roughness;
  return stroke;
}

/// Normal force at the beginning of each sample of some blocks.
std::vector<double> normal_force(RunningStroke& stroke, int blocks) {
  std::vector<double> force;
  for (int i = 0; i < blocks; ++i) {
    const std::vector<PointForce> places = stroke.next(0);
    for (std::size_t n = 0; n < RunningStroke::block; ++n) {
      force.push_back(places[0].force[n].begin + places[1].force[n].begin);
    }
  }
  return force;
}

/// Power around the mean of some samples, and that of the differences of neighbours.
struct Variation {
  double power = 0.0, of_steps = 0.0;

  explicit Variation(std::span<const double> force) {
    const double mean = std::accumulate(force.begin(), force.end(), 0.0) / static_cast<double>(force.size());
    for (std::size_t n = 1; n < force.size(); ++n) {
      power += std::pow(force[n] - mean, 2) / static_cast<double>(force.size());
      of_steps += std::pow(force[n] - force[n - 1], 2) / static_cast<double>(force.size());
    }
  }
};

constexpr std::size_t block = RunningStroke::block;

}  // namespace

TEST(RunningStroke, FollowsTheLoadWithinABlock) {
  RunningStroke stroke(slow_scrape(0.0), 1, rate);
  std::vector<double> force = normal_force(stroke, 2);
  EXPECT_EQ(force[0], 0.0);
  EXPECT_NEAR(force[block / 2], 1.0, 1e-12);
  EXPECT_NEAR(force.back(), 2.0, 1e-12);
  stroke.change(0.2, 6.0);
  force = normal_force(stroke, 2);
  EXPECT_NEAR(force[block / 4], 3.0, 1e-12);
  EXPECT_NEAR(force.back(), 6.0, 1e-12);
  EXPECT_FALSE(stroke.is_over());
  stroke.end();
  stroke.change(0.2, 1.0);
  force = normal_force(stroke, 1);
  EXPECT_NEAR(force[block / 2], 3.0, 1e-12);
  EXPECT_TRUE(stroke.is_over());
}

TEST(RunningStroke, HasTheRoughnessOfAStrokeThatIsKnownBefore) {
  for (const double speed : {0.1, 0.4}) {
    score::Stroke known = slow_scrape(1e-7);
    known.speed = speed;
    known.to.x() = speed;  // 1 s
    const std::vector<double> expected = stroke_force(known, 5, rate);
    RunningStroke stroke(known, 5, rate);
    const std::vector<double> found = normal_force(stroke, rate / static_cast<int>(block));
    const Variation one(std::span<const double>(expected).subspan(rate / 10, rate / 2)),
        other(std::span<const double>(found).subspan(rate / 10, rate / 2));
    EXPECT_NEAR(10.0 * std::log10(other.power / one.power), 0.0, 1.5) << speed;
    EXPECT_NEAR(10.0 * std::log10(other.of_steps / one.of_steps), 0.0, 1.5) << speed;
  }
}

TEST(RunningStroke, DoesNotJumpWhenItChanges) {
  RunningStroke stroke(slow_scrape(1e-7), 1, rate);
  static_cast<void>(normal_force(stroke, 3));
  stroke.change(0.25, 2.5);
  const std::vector<double> force = normal_force(stroke, 3);
  const double usual = std::sqrt(Variation(force).of_steps);
  for (const std::size_t border : {block, 2 * block}) {
    EXPECT_LT(std::abs(force[border] - force[border - 1]), 5.0 * usual);
  }
}

TEST(RunningStroke, GoesToAndFro) {
  RunningStroke stroke(slow_scrape(0.0), 1, rate);
  const double piece = 0.2 * static_cast<double>(block) / rate;  // m
  const int there = static_cast<int>(0.1 / piece);
  for (int i = 0; i < there; ++i) {
    const std::vector<PointForce> places = stroke.next(i);
    EXPECT_NEAR(places[0].at.x(), i * piece, 1e-9);
    EXPECT_NEAR(places[1].at.x(), (i + 1) * piece, 1e-9);
    EXPECT_EQ(places[0].direction.x(), 0.5) << "friction";
  }
  static_cast<void>(stroke.next(0));
  EXPECT_NEAR(stroke.next(0)[0].at.x(), 0.2 - (there + 1) * piece, 1e-9);
  EXPECT_EQ(stroke.next(0)[0].direction.x(), -0.5);
}

TEST(RunningStroke, RestsWithoutSpeedOrLoad) {
  RunningStroke stroke(slow_scrape(1e-6), 1, rate);
  stroke.change(0.0, 2.0);
  EXPECT_NEAR(normal_force(stroke, 2).back(), 2.0, 1e-9);
  stroke.change(0.0, 0.0);
  EXPECT_EQ(normal_force(stroke, 2).back(), 0.0);
  stroke.change(1000.0, 2.0);
  for (const double newtons : normal_force(stroke, 2)) {
    ASSERT_TRUE(std::isfinite(newtons));
  }
}

}  // namespace idiophone::resonators
