// Shapes of textbooks on nodes of simple bodies.

#include "idiophone/study/mode_kinds/mode_kinds.hpp"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <numbers>

namespace idiophone::mode_kinds {
namespace {

using std::numbers::pi;
using Field = std::function<Vector3(const Vector3& place)>;

/// Points of a box about the origin.
std::vector<Vector3> box(const Vector3& sides, std::array<int, 3> counts) {
  std::vector<Vector3> nodes;
  for (int i = 0; i < counts[0]; ++i) {
    for (int j = 0; j < counts[1]; ++j) {
      for (int k = 0; k < counts[2]; ++k) {
        nodes.emplace_back(sides[0] * (double(i) / (counts[0] - 1) - 0.5),
                           sides[1] * (double(j) / (counts[1] - 1) - 0.5),
                           sides[2] * (double(k) / (counts[2] - 1) - 0.5));
      }
    }
  }
  return nodes;
}

/// Points of a tube or a disc about the z axis.
std::vector<Vector3> round(double inner, double outer, double height, std::array<int, 3> counts) {
  std::vector<Vector3> nodes;
  for (int i = 0; i < counts[0]; ++i) {
    for (int j = 0; j < counts[1]; ++j) {
      for (int k = 0; k < counts[2]; ++k) {
        const double radius = inner + (outer - inner) * i / (counts[0] - 1), angle = 2 * pi * (j + 0.1 * k) / counts[1];
        nodes.emplace_back(radius * std::cos(angle), radius * std::sin(angle),
                           height * (double(k) / (counts[2] - 1) - 0.5));
      }
    }
  }
  return nodes;
}

std::vector<std::string> kinds(const std::vector<Vector3>& nodes, const std::vector<Field>& fields) {
  std::vector<std::vector<double>> shapes;
  for (const Field& field : fields) {
    auto& shape = shapes.emplace_back();
    for (const Vector3& node : nodes) {
      const Vector3 way = field(node);
      shape.insert(shape.end(), way.begin(), way.end());
    }
  }
  return kinds_of(nodes, shapes);
}

/// The same body turned and moved.
std::vector<std::string> turned_kinds(std::vector<Vector3> nodes, std::vector<Field> fields) {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Vector3(1, 2, 3).normalized()).toRotationMatrix();
  const Vector3 shift(1, 2, 3);
  for (Vector3& node : nodes) {
    node = Vector3(turn * node) + shift;
  }
  for (Field& field : fields) {
    field = [field, turn, shift](const Vector3& place) {
      const Vector3 before = turn.transpose() * (place - shift);
      const Vector3 way = field(before);
      return Vector3(turn * way);
    };
  }
  return kinds(nodes, fields);
}

const std::vector<Vector3> bar = box({0.3, 0.03, 0.01}, {31, 5, 3});

/// Bends along an axis by cos(k x); sections stay at right angles.
Field bending(int axis, double k) {
  return [=](const Vector3& x) {
    Vector3 way = Vector3::Zero();
    way[axis] = std::cos(k * x[0]);
    way[0] = x[axis] * k * std::sin(k * x[0]);
    return way;
  };
}

Field torsion(double k) {
  return [=](const Vector3& x) { return Vector3(0, -x[2] * std::sin(k * x[0]), x[1] * std::sin(k * x[0])); };
}

TEST(ModeKinds, OfABar) {
  const std::vector<Field> fields = {bending(2, 20), bending(1, 20), torsion(10), bending(2, 35),
                                     [](const Vector3& x) { return Vector3(std::sin(10 * x[0]), 0, 0); }};
  EXPECT_THAT(kinds(bar, fields), testing::ElementsAre("bending 1 along z", "bending 1 along y", "torsion 1",
                                                       "bending 2 along z", "longitudinal 1"));
  EXPECT_THAT(turned_kinds(bar, fields),
              testing::ElementsAre("bending 1 along the thickness", "bending 1 along the width", "torsion 1",
                                   "bending 2 along the thickness", "longitudinal 1"));
  EXPECT_THAT(kinds(bar, {[](const Vector3& x) { return Vector3(0, x[1] * std::cos(40 * x[0]), 0); }}),
              testing::ElementsAre(""))
      << "a change of its width";
}

TEST(ModeKinds, OfAPlate) {
  const std::vector<Vector3> plate = box({0.3, 0.2, 0.004}, {25, 17, 2});
  const auto lines = [](int m, int n, double side, double other) {
    return [=](const Vector3& x) {
      return Vector3(0, 0, std::cos(m * pi * (x[0] / side + 0.5)) * std::cos(n * pi * (x[1] / other + 0.5)));
    };
  };
  EXPECT_THAT(kinds(plate, {lines(2, 0, 0.3, 0.2), lines(1, 1, 0.3, 0.2), lines(4, 3, 0.3, 0.2),
                            [](const Vector3& x) { return Vector3(x[1], x[0], 0); }}),
              testing::ElementsAre("(2, 0)", "(1, 1)", "(4, 3)", "in plane 1"));
  EXPECT_THAT(turned_kinds(plate, {lines(4, 3, 0.3, 0.2)}), testing::ElementsAre("(4, 3)"));
  const Field a = lines(2, 0, 0.2, 0.2), b = lines(0, 2, 0.2, 0.2);
  EXPECT_THAT(kinds(box({0.2, 0.2, 0.004}, {21, 21, 2}), {[&](const Vector3& x) {
                      const Vector3 first = a(x), second = b(x);
                      return Vector3(first - 0.9 * second);
                    }}),
              testing::ElementsAre("(2, 0) + (0, 2)"));
}

TEST(ModeKinds, OfADiscAndAShell) {
  const auto height = [](int m, auto along) {
    return [=](const Vector3& x) {
      return Vector3(0, 0, along(std::hypot(x[0], x[1])) * std::cos(m * std::atan2(x[1], x[0]) + 0.4));
    };
  };
  const auto in_plane = [](int m, double phase, auto along) {
    return [=](const Vector3& x) {
      const double angle = std::atan2(x[1], x[0]);
      const double radial = std::cos(m * angle) * std::cos(phase), tangential = std::cos(m * angle) * std::sin(phase);
      const double size = along(x[2]);
      return Vector3(size * (radial * std::cos(angle) - tangential * std::sin(angle)),
                     size * (radial * std::sin(angle) + tangential * std::cos(angle)), 0);
    };
  };
  const auto even = [](double /*z*/) { return 1.0; };
  const std::vector<Field> of_disc = {
      height(2, [](double r) { return r * r; }), height(0, [](double r) { return 1 - 2 * r * r; }),
      height(1, [](double r) { return r - 2 * r * r * r; }), in_plane(2, 0, even), in_plane(0, pi / 2, even)};
  const std::vector<Vector3> disc = round(0.0, 1.0, 0.05, {12, 36, 2});
  const auto expected = testing::ElementsAre("(2, 0)", "(0, 1)", "(1, 1)", "in plane (2)", "torsion 1");
  EXPECT_THAT(kinds(disc, of_disc), expected);
  EXPECT_THAT(turned_kinds(disc, of_disc), expected);
  const std::vector<Vector3> tube = round(0.9, 1.0, 3.0, {2, 40, 20});
  const auto wave = [](double z) { return std::sin(2 * pi * z / 3.0); };
  EXPECT_THAT(
      turned_kinds(tube, {in_plane(2, 0, even), in_plane(3, 0, wave), in_plane(0, 0, even), in_plane(0, pi / 2, wave)}),
      testing::ElementsAre("(2, 0)", "(3, 1)", "(0, 0)", "torsion 1"));
  EXPECT_TRUE(is_round(disc));
  EXPECT_TRUE(is_round(tube));
  for (const int around : {12, 24}) {  // with nodes on the borders of parts, where rounding deals them to both
    EXPECT_TRUE(is_round(round(0.0, 1.0, 0.1, {3, around, 3}))) << around;
  }
  EXPECT_FALSE(is_round(box({1, 1, 0.05}, {8, 8, 2})));
}

TEST(ModeKinds, OfABarOnSoftSupportsAreRigidMotionsBelowThoseOfTheBar) {
  const std::vector<Vector3> nodes = box({1, 0.1, 0.05}, {41, 5, 3});
  const Field rocks = [](const Vector3& x) { return Vector3(-x[2], 0, x[0] + 0.2); };
  const Field swings = [](const Vector3& x) { return Vector3(0, 1, 0.02 * std::cos(2 * pi * x[0])); };
  const Field of_cantilever = [](const Vector3& x) { return Vector3(0, 0, (x[0] + 0.5) * (x[0] + 0.5)); };
  EXPECT_THAT(kinds(nodes, {rocks, swings, of_cantilever}),
              testing::ElementsAre("rigid motion 1", "rigid motion 2", "bending 1 along z"));
}

TEST(ModeKinds, OfACantileverWithManyNodesAtItsEndIsABending) {
  std::vector<Vector3> nodes = box({1, 0.1, 0.05}, {41, 5, 3});
  for (Vector3& node : nodes) {
    node[0] = 0.5 - std::pow(0.5 - node[0], 3);  // most of them near the end at x = 0.5
  }
  const Field of_cantilever = [](const Vector3& x) {
    return Vector3(0, 0, (x[0] + 0.5) * (x[0] + 0.5) * (2.5 - x[0]));
  };
  EXPECT_THAT(kinds(nodes, {of_cantilever}), testing::ElementsAre("bending 1 along z"));
}

TEST(ModeKinds, OfOtherBodiesHaveNoNames) {
  const Field any = [](const Vector3& x) { return Vector3(x[1], x[2], x[0]); };
  EXPECT_THAT(kinds(box({1, 1, 0.9}, {5, 5, 5}), {any}), testing::ElementsAre(""));
  EXPECT_THAT(kinds({Vector3(0, 0, 0), Vector3(1, 0, 0), Vector3(0, 1, 0), Vector3(0, 0, 1)}, {any}),
              testing::ElementsAre(""));
}

/// Two boxes, and fields over the first and the second one.
struct TwoBodies {
  [[nodiscard]] std::vector<std::string> kinds(bool is_one_piece, const std::vector<std::array<Field, 2>>& modes,
                                               const std::vector<std::vector<double>>& shares) const {
    const std::array<std::span<const Vector3>, 2> bodies = {first, second};
    std::vector<std::vector<double>> shapes;
    for (const std::array<Field, 2>& fields : modes) {
      auto& shape = shapes.emplace_back();
      for (const std::size_t b : {0, 1}) {
        for (const Vector3& node : bodies[b]) {
          const Vector3 way = fields[b](node);
          shape.insert(shape.end(), way.begin(), way.end());
        }
      }
    }
    return kinds_of_assembly(std::array{JoinedBody{"left", first}, JoinedBody{"right", second}}, is_one_piece, shapes,
                             shares);
  }

  std::vector<Vector3> first, second;
};

const Field at_rest = [](const Vector3& /*x*/) { return Vector3(0, 0, 0); };

TEST(ModeKinds, OfOnePieceAreThoseOfTheWhole) {
  std::vector<Vector3> left, right;
  for (const Vector3& node : bar) {
    (node.x() < -0.025 ? left : right).push_back(node);
  }
  const TwoBodies cut = {left, right};
  const auto both = [](const Field& field) { return std::array{field, field}; };
  const std::vector<std::array<Field, 2>> modes = {both(bending(2, 20)), both(bending(1, 20)), both(torsion(10)),
                                                   both(bending(2, 35))};
  const std::vector<std::vector<double>> shares(4, {0.05, 0.95});
  EXPECT_THAT(cut.kinds(true, modes, shares),
              testing::ElementsAre("bending 1 along z", "bending 1 along y", "torsion 1", "bending 2 along z"));
}

TEST(ModeKinds, OfBodiesOnSpringsAreThoseOfTheBodyThatHasTheEnergy) {
  std::vector<Vector3> beside = bar;
  std::ranges::for_each(beside, [](Vector3& node) { node.y() += 0.05; });
  const TwoBodies apart = {bar, beside};
  const std::vector<std::array<Field, 2>> modes = {{bending(2, 20), at_rest},
                                                   {at_rest, bending(2, 20)},
                                                   {bending(2, 20), bending(2, 20)},
                                                   {bending(2, 35), at_rest}};
  const std::vector<std::vector<double>> shares = {{0.95, 0.05}, {0.05, 0.95}, {0.5, 0.5}, {1.0, 0.0}};
  EXPECT_THAT(
      apart.kinds(false, modes, shares),
      testing::ElementsAre("left: bending 1 along z", "right: bending 1 along z", "", "left: bending 2 along z"));
}

TEST(ModeKinds, OfOnePieceWithoutASimpleFormAreThoseOfTheBodyThatHasTheEnergy) {
  std::vector<Vector3> across;
  for (const Vector3& node : bar) {
    across.emplace_back(node.y(), node.x(), node.z() + 0.01);
  }
  const TwoBodies cross = {bar, across};
  EXPECT_THAT(
      cross.kinds(true, {{bending(2, 20), at_rest}, {bending(2, 20), bending(2, 20)}}, {{0.95, 0.05}, {0.5, 0.5}}),
      testing::ElementsAre("left: bending 1 along z", ""));
}

}  // namespace
}  // namespace idiophone::mode_kinds
