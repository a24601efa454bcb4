#include "idiophone/instruments/voices/falling_piece.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <memory>

#include "tile_voices.hpp"

namespace idiophone::voices {

namespace {

constexpr double fall_step = 2.5e-4;  // s, of the flights
const Vector3 earth(0, 0, -9.81);     // m/s2

/// A brick of 1 kg about the origin, whose corners touch.
RigidPiece brick(const Vector3& size) {
  RigidPiece piece{.mass = 1.0, .second = Vector3(size.cwiseAbs2() / 12).asDiagonal()};
  for (int corner = 0; corner < 8; ++corner) {
    piece.points.push_back(0.5 * size.cwiseProduct(Vector3((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1,
                                                           (corner & 4) != 0 ? 1 : -1)));
  }
  return piece;
}

Ground floor_at(double height) {
  return {.gravity = earth, .floors = {{.at = {0, 0, height}}}};
}

}  // namespace

TEST(FallingPiece, LandsWhenTheLawOfFreeFallSays) {
  RigidPiece ball{.mass = 0.5, .second = 1e-4 * Eigen::Matrix3d::Identity(), .points = {{0, 0, -0.02}}};
  FallingPiece piece(ball, {.centre = {0, 0, 1.02}, .velocity = {2, 0, 1}}, 0.25, floor_at(0.0));
  const double expected = (1 + std::sqrt(1 + 2 * 9.81)) / 9.81;  // s: of a height of 1 m, thrown up with 1 m/s
  EXPECT_TRUE(piece.advance(0.25 + expected - 2 * fall_step).empty());
  const std::vector<Landing> landings = piece.advance(0.25 + expected + fall_step);
  ASSERT_EQ(landings.size(), 1U);
  EXPECT_NEAR(landings[0].time, 0.25 + expected, fall_step);
  const double speed = std::sqrt(1 + 2 * 9.81);
  EXPECT_NEAR(landings[0].speed, speed, 9.81 * fall_step);
  EXPECT_NEAR(landings[0].impulse.z(), 1.3 * 0.5 * speed, 1e-2);
  EXPECT_NEAR(piece.at(landings[0].time).velocity.z(), 0.3 * landings[0].speed, 1e-12);
  EXPECT_NEAR(piece.at(landings[0].time).centre.x(), 2 * (landings[0].time - 0.25), 1e-12);
}

TEST(FallingPiece, KeepsItsMomentaAndEnergyInFlight) {
  FallingPiece piece(brick({0.1, 0.05, 0.02}), {.velocity = {1, 2, 3}, .angular_momentum = {0.01, -0.02, 0.005}}, 0.0,
                     {.gravity = earth});
  const RigidState begin = piece.at(0.0);
  for (const double time : {0.1, 0.3, 1.0}) {
    EXPECT_TRUE(piece.advance(time).empty());
    const RigidState now = piece.at(time);
    EXPECT_EQ(now.angular_momentum, begin.angular_momentum);
    EXPECT_LT((now.centre - Vector3(1, 2, 3) * time - 0.5 * time * time * earth).norm(), 1e-12);
    EXPECT_NEAR(piece.energy(now), piece.energy(begin), 1e-4 * piece.energy(begin));
  }
}

TEST(FallingPiece, ImpactsNeverAddEnergyAndEndInRest) {
  for (const Vector3& tilt : {Vector3(0, 0, 0), Vector3(0.3, 0.2, 0.1), Vector3(1, -1, 0.5)}) {
    const RigidState begin{.centre = {0, 0, 0.5},
                           .turn = Eigen::Quaterniond(Eigen::AngleAxisd(tilt.norm(), tilt.stableNormalized())),
                           .velocity = {1, 0, 0},
                           .angular_momentum = {0.002, 0.001, -0.001}};
    FallingPiece piece(brick({0.1, 0.05, 0.02}), begin, 0.0, floor_at(0.0));
    double energy = piece.energy(begin);
    const double most = energy;
    int landings = 0;
    for (int step = 1; step < 40000 && !piece.rests(); ++step) {
      landings += static_cast<int>(piece.advance(step * fall_step + 1e-9).size());
      const double now = piece.energy(piece.at(step * fall_step));
      EXPECT_LT(now, energy + 1e-6 * most) << step;
      energy = now;
    }
    EXPECT_GT(landings, 2);
    EXPECT_TRUE(piece.rests());
    const RigidState end = piece.at(100.0);
    EXPECT_LT(end.centre.z(), 0.06);
    EXPECT_GT(end.centre.z(), 0.005);
    EXPECT_EQ(end.velocity, Vector3::Zero());
  }
}

namespace {

constexpr int falling_rate = 16000;

struct BrokenTile {
  std::vector<double> sound;
  std::vector<proxies::Fracture> fractures;
};

/// A tile of 60 x 60 x 5 mm that a blow from above breaks, and what is heard of it.
BrokenTile broken_tile(const Ground& ground) {
  const auto voices = tile_voices({.cells = 6, .damping = 50.0, .tensile = 1e6}, falling_rate);
  voices->fall_on(ground);
  strike_tile(*voices, 1.0);
  BrokenTile tile{.sound = std::vector<double>(6400), .fractures = {}};
  voices->render(tile.sound, 0);
  tile.fractures = voices->fractures();
  return tile;
}

}  // namespace

TEST(FallingPiece, ShardsOfAProxySoundWhenTheyLand) {
  constexpr double depth = 0.3;  // m: of the floor below the tile
  const BrokenTile flying = broken_tile({.gravity = earth}), falling = broken_tile(floor_at(-depth));
  ASSERT_GE(falling.fractures.size(), 1U);
  ASSERT_GE(falling.fractures[0].pieces.size(), 2U);
  double first = 1.0;  // s: by the law of free fall, of any piece of the first break that does not break again
  for (const proxies::Fracture& fracture : falling.fractures) {
    for (const proxies::Piece& piece : fracture.pieces) {
      const double down = -piece.motion.velocity.z();
      const double fall = (std::sqrt(down * down + 2 * 9.81 * depth) - down) / 9.81;
      first = std::min(first, static_cast<double>(fracture.sample) / falling_rate + fall);
    }
  }
  std::size_t different = 0;
  while (different < falling.sound.size() && falling.sound[different] == flying.sound[different]) {
    ++different;
  }
  const double way = (1.0 + depth) / 343.0;  // s, of the sound
  EXPECT_NEAR(static_cast<double>(different) / falling_rate, first + way, 0.01);
  double loudest = 0.0, without = 0.0;
  for (std::size_t i = different; i < falling.sound.size(); ++i) {
    loudest = std::max(loudest, std::abs(falling.sound[i]));
    without = std::max(without, std::abs(flying.sound[i]));
  }
  EXPECT_GT(loudest, 2 * without);
}

}  // namespace idiophone::voices
