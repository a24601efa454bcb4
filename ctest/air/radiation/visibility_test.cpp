// What is seen from where: walls, closed bodies, planes, a body's own shadow.

#include "idiophone/air/radiation/visibility.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <numbers>

namespace idiophone::radiation {
namespace {

/// Adds the twelve triangles of a box, their corners around the outward normal, to the occluders as one more body.
void add_box(Occluders& occluders, const Vector3& centre, const Vector3& size) {
  if (occluders.first_triangle.empty()) {
    occluders.first_triangle = {0};
  }
  const auto first = static_cast<Index>(occluders.positions.size() / 3);
  for (int corner = 0; corner < 8; ++corner) {
    for (int axis = 0; axis < 3; ++axis) {
      const double side = (corner >> axis & 1) != 0 ? 0.5 : -0.5;
      occluders.positions.push_back(static_cast<float>(centre[axis] + side * size[axis]));
    }
  }
  constexpr std::array<std::array<Index, 4>, 6> faces{
      {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
  for (const auto& [a, b, c, d] : faces) {
    occluders.triangles.push_back({first + a, first + b, first + c});
    occluders.triangles.push_back({first + a, first + c, first + d});
  }
  occluders.first_triangle.push_back(static_cast<Index>(occluders.triangles.size()));
}

constexpr Index bottom = 8, top = 10;  // triangles of a box

Occluders one_box() {
  Occluders occluders;
  add_box(occluders, Vector3::Zero(), Vector3::Ones());
  return occluders;
}

TEST(Visibility, OfAConvexBodyIsOneOnAllSides) {
  const Visibility visibility(one_box(), SelfOcclusion::included);
  for (Index triangle = 0; triangle < 12; ++triangle) {
    for (const Vector3& point : {Vector3(0.3, 0.2, 5), Vector3(-7, 1, 0.1), Vector3(0.49, 0.49, 0.500001)}) {
      EXPECT_TRUE(visibility.sees(triangle, point)) << triangle;  // also where it faces away: see the constructor
    }
  }
}

TEST(Visibility, IsBlockedByAnotherBody) {
  Occluders occluders = one_box();
  add_box(occluders, {0, 0, 2}, {3, 3, 0.1});
  const Visibility visibility(occluders, SelfOcclusion::included);
  EXPECT_FALSE(visibility.sees(top, {0, 0, 5}));
  EXPECT_TRUE(visibility.sees(top, {0, 0, 1.9}));  // before the wall
  EXPECT_TRUE(visibility.sees(top, {9, 0, 3}));    // past its edge
  EXPECT_FALSE(visibility.sees(12 + bottom, {0, 0, -3}));
  EXPECT_TRUE(visibility.sees(12 + top, {0, 0, 5}));
}

TEST(Visibility, IsBlockedByObstaclesFromBothSides) {
  Occluders occluders = one_box();
  const std::array<Vector3, 3> corners{Vector3(-9, -9, 2), Vector3(9, -9, 2), Vector3(0, 9, 2)};
  occluders.obstacles = {corners};
  EXPECT_FALSE(Visibility(occluders, SelfOcclusion::included).sees(top, {0, 0, 5}));
  occluders.obstacles = {{corners[0], corners[2], corners[1]}};
  EXPECT_FALSE(Visibility(occluders, SelfOcclusion::included).sees(top, {0, 0, 5}));
  EXPECT_TRUE(Visibility(occluders, SelfOcclusion::included).sees(top, {0, 0, 1}));
}

TEST(Visibility, EndsAtAHalfSpace) {
  Occluders occluders = one_box();
  occluders.half_spaces = {{{0, 0, -0.4}, {0, 0, 1}}};
  const Visibility visibility(occluders, SelfOcclusion::included);
  EXPECT_TRUE(visibility.sees(top, {0, 0, 5}));
  EXPECT_FALSE(visibility.sees(top, {0, 0, -0.41}));    // the point is behind
  EXPECT_FALSE(visibility.sees(bottom, {9, 0, -0.3}));  // the triangle is
}

TEST(Visibility, DoesNotReachIntoOrOutOfAClosedBody) {
  Occluders occluders;
  add_box(occluders, Vector3::Zero(), Vector3::Constant(0.1));
  add_box(occluders, Vector3::Zero(), Vector3::Ones());
  const Visibility visibility(occluders, SelfOcclusion::included);
  for (Index triangle = 0; triangle < 12; ++triangle) {
    for (const Vector3& direction : {Vector3(0.1, 0.2, 1), Vector3(-1, 0.3, 0.1), Vector3(0.2, -1, -0.4)}) {
      EXPECT_FALSE(visibility.sees(triangle, 5 * direction));  // from inside to outside
      EXPECT_TRUE(visibility.sees(triangle, 0.3 * direction));
    }
  }
  Occluders apart;
  add_box(apart, {3, 0, 0}, Vector3::Ones());
  add_box(apart, Vector3::Zero(), Vector3::Ones());
  for (Index triangle = 0; triangle < 12; ++triangle) {
    EXPECT_FALSE(Visibility(apart, SelfOcclusion::included).sees(triangle, {0, 0, 0}));  // from outside to inside
  }
}

/// Two boxes side by side as one body: a concave one.
Occluders pair_as_one_body() {
  Occluders occluders = one_box();
  add_box(occluders, {0, 0, 3}, Vector3::Ones());
  occluders.first_triangle = {0, 24};
  return occluders;
}

TEST(Visibility, OfAConcaveBodyEndsAtItself) {
  EXPECT_FALSE(Visibility(pair_as_one_body(), SelfOcclusion::included).sees(top, {0, 0, 5}));
  EXPECT_TRUE(Visibility(pair_as_one_body(), SelfOcclusion::included).sees(top, {0, 9, 1}));
}

TEST(Visibility, MayLeaveTheOwnBodyOut) {
  Occluders occluders = pair_as_one_body();
  EXPECT_TRUE(Visibility(occluders, SelfOcclusion::excluded).sees(top, {0, 0, 5}));
  add_box(occluders, {0, 0, 6}, {3, 3, 0.1});
  EXPECT_TRUE(Visibility(occluders, SelfOcclusion::excluded).sees(top, {0, 0, 5}));
  EXPECT_FALSE(Visibility(occluders, SelfOcclusion::excluded).sees(top, {0, 0, 7}));
}

TEST(Visibility, FollowsTheBodies) {
  Occluders occluders = one_box();
  add_box(occluders, {0, 0, 2}, {3, 3, 0.1});
  Visibility visibility(occluders, SelfOcclusion::included);
  const auto shift = [&](float by) {
    for (std::size_t vertex = 8; vertex < 16; ++vertex) {
      visibility.positions()[3 * vertex] += by;
    }
    visibility.move();
  };
  const Vector3 point(0, 0, 5);
  EXPECT_FALSE(visibility.sees(top, point));
  for (int round = 0; round < 20; ++round) {
    shift(10);
    EXPECT_TRUE(visibility.sees(top, point));
    shift(-10);
    EXPECT_FALSE(visibility.sees(top, point));
  }
}

TEST(Visibility, ATurningPlateShowsItsSidesInTurnAndWhatIsBehindItTwiceATurn) {
  Occluders occluders;
  add_box(occluders, {0, 0, -1}, {0.1, 0.1, 0.1});
  add_box(occluders, Vector3::Zero(), {1, 1, 0.02});
  const std::vector<float> unturned = occluders.positions;
  Visibility visibility(occluders, SelfOcclusion::included);
  const Vector3 listener(0, 0, 50);
  for (int degrees = 0; degrees < 360; degrees += 5) {
    const Eigen::AngleAxisf turn(static_cast<float>(degrees * std::numbers::pi / 180), Eigen::Vector3f::UnitY());
    for (std::size_t corner = 8; corner < 16; ++corner) {
      Eigen::Vector3f::Map(&visibility.positions()[3 * corner]) = turn * Eigen::Vector3f::Map(&unturned[3 * corner]);
    }
    visibility.move();
    const bool edge_on = degrees % 180 == 90;
    EXPECT_EQ(visibility.sees(top, listener), edge_on) << degrees;
    if (!edge_on) {
      // One side faces the listener and hides nothing of itself; the model silences the other one.
      const Index facing = std::cos(degrees * std::numbers::pi / 180) > 0 ? top : bottom;
      EXPECT_TRUE(visibility.sees(12 + facing, listener)) << degrees;
      EXPECT_TRUE(visibility.sees(12 + facing + 1, listener)) << degrees;
    }
  }
}

TEST(Visibility, DependsOnPositionsAloneNotOnWhatWasBefore) {
  // Rays along edges and through corners of the boxes in the way, where round-off decides.
  Occluders occluders;
  for (int box = 0; box < 5; ++box) {
    add_box(occluders, {0.37 * box, 0.11 * box * box, 2.0 * box}, Vector3::Constant(1.0 + 0.1 * box));
  }
  const auto place = [](Visibility& visibility, double turn) {
    const Eigen::Matrix3f rotation = Eigen::AngleAxisd(turn, Vector3(1, 2, 2) / 3).toRotationMatrix().cast<float>();
    const std::vector<float> before(visibility.positions().begin(), visibility.positions().end());
    for (std::size_t vertex = 0; vertex < 40; ++vertex) {
      Eigen::Vector3f::Map(&visibility.positions()[3 * vertex]) = rotation * Eigen::Vector3f::Map(&before[3 * vertex]);
    }
    visibility.move();
  };
  Visibility turned(occluders, SelfOcclusion::included);
  for (int step = 0; step < 25; ++step) {
    place(turned, 0.3);
  }
  Visibility at_once(occluders, SelfOcclusion::included);
  std::ranges::copy(turned.positions(), at_once.positions().begin());
  at_once.move();
  int seen = 0;
  for (Index triangle = 0; triangle < 60; ++triangle) {
    for (std::size_t vertex = 0; vertex < 40; ++vertex) {
      const Vector3 corner = Eigen::Vector3f::Map(&turned.positions()[3 * vertex]).cast<double>();
      for (const double beyond : {0.999, 1.0, 1.5}) {
        EXPECT_EQ(turned.sees(triangle, beyond * corner), at_once.sees(triangle, beyond * corner));
        seen += turned.sees(triangle, beyond * corner) ? 1 : 0;
      }
    }
  }
  EXPECT_GT(seen, 500);
  EXPECT_LT(seen, 6500);
}

TEST(Visibility, SurvivesPositionsThatAreNotFinite) {
  using Limits = std::numeric_limits<float>;
  for (const float lost : {Limits::quiet_NaN(), Limits::infinity(), Limits::max(), -Limits::max()}) {
    for (const std::size_t numbers : {1, 5, 24, 48}) {
      Occluders occluders = one_box();
      add_box(occluders, {0, 0, 2}, {3, 3, 0.1});
      Visibility visibility(occluders, SelfOcclusion::included);
      std::ranges::fill(visibility.positions().last(numbers), lost);
      visibility.move();
      for (Index triangle = 0; triangle < 24; ++triangle) {
        (void)visibility.sees(triangle, {9, 0, 1});
      }
      EXPECT_TRUE(visibility.sees(top, Vector3::Constant(lost)));
    }
  }
}

TEST(Visibility, RefusesABodyThatIsAPointInSinglePrecision) {
  Occluders occluders = one_box();
  add_box(occluders, {2e5, 0, 0}, Vector3::Ones());
  EXPECT_THROW(Visibility(occluders, SelfOcclusion::included), std::runtime_error);
}

TEST(Visibility, RefusesVerticesThatAreNotThere) {
  Occluders occluders = one_box();
  occluders.triangles[3][1] = 8;
  EXPECT_THROW(Visibility(occluders, SelfOcclusion::included), std::invalid_argument);
}

}  // namespace
}  // namespace idiophone::radiation
