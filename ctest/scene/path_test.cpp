#include <cmath>
#include <numbers>

#include "deck_fixture.hpp"

namespace idiophone::scene {

namespace {

constexpr double pi = std::numbers::pi;

/// Points of a motion at these times.
template <class Motion>
Path points_of(const Motion& motion, const std::vector<double>& times) {
  Path path;
  for (const double time : times) {
    path.points.push_back({time, motion(time)});
  }
  return path;
}

Vector3 circle(double time) {
  return {std::cos(time), std::sin(time), 0.0};
}

/// Largest distance from the circle's motion, with a point each `step` seconds.
double error_on_circle(double step) {
  std::vector<double> times;
  for (int i = -1; i * step < 2.0 * pi + 2.0 * step; ++i) {
    times.push_back(i * step);
  }
  const Path path = points_of(circle, times);
  double error = 0.0;
  for (int i = 0; i < 628; ++i) {
    const double time = 0.01 * i;
    error = std::max(error, (path.at(time).position - circle(time)).norm());
  }
  return error;
}

}  // namespace

TEST(Path, SteadyPointsGiveASteadyMotionForEver) {
  const Vector3 start(1, 2, 3);
  const Vector3 velocity(20, -1, 0.5);
  const Path path = points_of([&](double t) { return start + t * velocity; }, {0.0, 0.1, 0.15, 2.0});
  for (const double time : {-1.0, 0.0, 0.05, 0.12, 0.15, 1.99, 2.0, 5.0}) {
    EXPECT_NEAR((path.at(time).position - (start + time * velocity)).norm(), 0.0, 1e-13) << time;
    EXPECT_NEAR((path.at(time).velocity - velocity).norm(), 0.0, 1e-12) << time;
  }
  EXPECT_NEAR(path.fastest(), velocity.norm(), 1e-12);
}

TEST(Path, GoesThroughItsPointsWithoutAJumpOfPositionOrVelocity) {
  const Path path{.points = {{0.0, {0, 0, 0}}, {1.0, {0, 0, 0}}, {1.5, {2, 0, 0}}, {3.0, {2, 4, 0}}, {4.0, {2, 4, 0}}},
                  .where = {}};
  for (const auto& [time, position] : path.points) {
    constexpr double moment = 1e-9;
    const Place before = path.at(time - moment);
    const Place after = path.at(time + moment);
    EXPECT_NEAR((path.at(time).position - position).norm(), 0.0, 1e-14);
    EXPECT_NEAR((after.position - before.position).norm(), 0.0, 1e-7) << time;
    EXPECT_NEAR((after.velocity - before.velocity).norm(), 0.0, 1e-6) << time;
  }
  EXPECT_EQ(path.at(-1.0).velocity, Vector3::Zero());  // stands where it begins and ends with equal points
  EXPECT_EQ(path.at(9.0).position, Vector3(2, 4, 0));
}

TEST(Path, VelocityIsTheDerivativeOfThePositionAndNeverAboveTheFastest) {
  const Path path{.points = {{0.0, {0, 0, 0}}, {1.0, {0, 1, 0}}, {1.5, {2, 0, 0}}, {3.0, {2, 4, -1}}}, .where = {}};
  double fastest = 0.0;
  for (int i = 0; i < 244; ++i) {
    const double time = 0.001 + 0.0123 * i;
    const Vector3 difference = (path.at(time + 1e-6).position - path.at(time - 1e-6).position) / 2e-6;
    EXPECT_NEAR((path.at(time).velocity - difference).norm(), 0.0, 1e-5) << time;
    fastest = std::max(fastest, difference.norm());
  }
  EXPECT_LE(fastest, path.fastest());
  EXPECT_GE(fastest, 0.5 * path.fastest());
}

TEST(Path, ConvergesToASmoothMotionWithThirdOrder) {
  const double coarse = error_on_circle(2.0 * pi / 16);
  const double fine = error_on_circle(2.0 * pi / 32);
  EXPECT_LT(coarse, 0.01);
  EXPECT_NEAR(std::log2(coarse / fine), 3.5, 0.75);
}

using PathTest = DeckTest;

TEST_F(PathTest, MovesTheReceiversOfAListener) {
  write("walk.csv", "# time, x, y, z\n0, 1, 0, 0\n2, 1, 4, 0\n");
  const Scene scene = read(replaced(plate, "mono, position: [0, 0, 1]",
                                    "stereo, path: walk.csv, look: [0, 1, 0], up: [0, 0, 1], separation: 0.5"));
  const Listener& listener = scene.listeners.at(0);
  const Place left = listener.place(listener.receivers.at(0), 1.0);
  EXPECT_TRUE(left.position.isApprox(Vector3(0.75, 2, 0), 1e-14)) << left.position.transpose();
  EXPECT_TRUE(left.velocity.isApprox(Vector3(0, 2, 0), 1e-14));
  EXPECT_TRUE(listener.receivers.at(1).position.isApprox(Vector3(1.25, 0, 0), 1e-14));
}

TEST_F(PathTest, RowsThatAreWrongAreAnsweredWithTheirPlace) {
  const std::string deck = replaced(plate, "position: [0, 0, 1]", "path: walk.csv");
  const auto answer = [&](const std::string& csv) {
    write("walk.csv", csv);
    return mistakes(deck);
  };
  EXPECT_EQ(answer("0, 0, 0\n1, 0, 0, 0\n"), "DIR/walk.csv:1:8: expected a comma between y and z, found ''");
  EXPECT_EQ(answer("0, 0, a, 0\n1, 0, 0, 0\n"), "DIR/walk.csv:1:7: expected a y, found 'a, 0'");
  EXPECT_EQ(answer("0, 0, 0, 0\n1, 0, 0, 0, 7\n"),
            "DIR/walk.csv:2:11: unexpected ', 7' after the z: a row has 4 numbers");
  EXPECT_EQ(answer("0, 0, 0, 0\n"),
            "deck.yaml:10:27: listeners.ear.path: needs at least 2 rows 'time, x, y, z', found 1 in DIR/walk.csv");
  EXPECT_THAT(answer("0, 0, 0, 0\n1, 0, 0, 2e6\n"), testing::HasSubstr("farther than 10000 m from the origin"));
  EXPECT_EQ(answer("0, 0, 0, 0\n1, 0, 0, 343\n"),
            "deck.yaml:10:27: listeners.ear.path: moves at up to 343 m/s; it must be slower than sound, 343 m/s");
  EXPECT_EQ(answer("0, 0, 0, 0\n1, 0, 0, 342\n"), "no mistakes");
  EXPECT_THAT(mistakes(replaced(plate, "position:", "path: walk.csv, position:")),
              testing::HasSubstr("listeners.ear.position: the path gives the position already"));
}

TEST_F(PathTest, MayStandInTheDeck) {
  const auto with = [&](const std::string& path) { return replaced(plate, "position: [0, 0, 1]", "path: " + path); };
  const Listener listener = read(with("[[0, 1, 0, 0], [2, 1, 4, 0]]")).listeners.at(0);
  EXPECT_EQ(listener.path->points.at(1).time, 2.0);
  EXPECT_EQ(listener.path->points.at(1).position, Vector3(1, 4, 0));
  EXPECT_EQ(mistakes(with("[[0, 1, 0, 0], [0, 1, 4, 0]]")),
            "deck.yaml:10:42: listeners.ear.path.1: times must ascend; 0 s does not follow 0 s");
  EXPECT_EQ(mistakes(with("[[0, 1, 0, 0]]")),
            "deck.yaml:10:27: listeners.ear.path: needs at least 2 rows [time, x, y, z], found 1");
  EXPECT_THAT(mistakes(with("[[0, 1, 0, 0], [1, 2]]")), testing::HasSubstr("expected a row [time, x, y, z]"));
  EXPECT_THAT(mistakes(with("[[-1, 1, 0, 0], [1, 1, 0, x]]")), testing::HasSubstr("must be at least 0"));
}

}  // namespace idiophone::scene
