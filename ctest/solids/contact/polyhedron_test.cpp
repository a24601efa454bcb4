// Convex polyhedra that planes cut down, by exact volumes.

#include "polyhedron.hpp"
#include "ranks.hpp"

#include <gtest/gtest.h>

#include <random>

namespace idiophone::contact {
namespace {

/// The corner of the unit cube: volume 1/6, centroid (1/4, 1/4, 1/4).
const Tetrahedron corner({Vector3(0, 0, 0), Vector3(1, 0, 0), Vector3(0, 1, 0), Vector3(0, 0, 1)});

Polyhedron cut(const std::vector<Plane>& planes) {
  Polyhedron polyhedron;
  polyhedron.become(corner);
  int number = 4;
  for (const Plane& plane : planes) {
    polyhedron.clip(plane, number++);
  }
  return polyhedron;
}

/// Everything below x = `place`.
Plane below(const Vector3& direction, double place) {
  return {direction.normalized(), place * direction.normalized()};
}

/// Sum of the faces as vectors, m2: zero for a closed surface.
Vector3 sum_of_faces(const Polyhedron& polyhedron) {
  Vector3 sum = Vector3::Zero();
  for (std::size_t f = 0; f < polyhedron.face_count(); ++f) {
    const auto corners = polyhedron.face(f).corners;
    for (std::size_t i = 2; i < corners.size(); ++i) {
      sum += (corners[i - 1] - corners[0]).cross(corners[i] - corners[0]) / 2;
    }
  }
  return sum;
}

ON_RANKS(1);

TEST(Polyhedra, BeginAsATetrahedron) {
  const Polyhedron polyhedron = cut({});
  EXPECT_NEAR(polyhedron.moments().volume, 1.0 / 6, 1e-16);
  EXPECT_LT((polyhedron.moments().first - Vector3::Constant(1.0 / 24)).norm(), 1e-16);
  ASSERT_EQ(polyhedron.face_count(), 4U);
  for (std::size_t f = 0; f < 4; ++f) {  // face f is opposite corner f
    EXPECT_EQ(polyhedron.face(f).number, static_cast<int>(f));
    for (const Vector3& place : polyhedron.face(f).corners) {
      EXPECT_NE(place, corner.corners.at(f));
    }
  }
}

TEST(Polyhedra, LoseWhatIsOutsideOfAPlane) {
  constexpr double a = 0.3;
  const Polyhedron::Moments slice = cut({below(Vector3::UnitX(), a)}).moments();  // x < a
  EXPECT_NEAR(slice.volume, (1 - std::pow(1 - a, 3)) / 6, 1e-15);
  // Integral of x (1 - x)^2 / 2 from 0 to a.
  EXPECT_NEAR(slice.first.x(), a * a / 4 - a * a * a / 3 + a * a * a * a / 8, 1e-15);
  const Polyhedron::Moments tip = cut({below(Vector3(1, 1, 1), a / std::sqrt(3.0))}).moments();  // x + y + z < a
  EXPECT_NEAR(tip.volume, a * a * a / 6, 1e-15);
  EXPECT_NEAR(tip.first.y(), a * a * a * a / 24, 1e-15);
}

TEST(Polyhedra, GiveTheFaceOfTheCutItsNumber) {
  const Polyhedron polyhedron = cut({below(Vector3(1, 1, 1), 0.1), below(Vector3(1, 1, 1), 0.05)});
  ASSERT_EQ(polyhedron.face_count(), 4U);
  std::multiset<int> numbers;
  for (std::size_t f = 0; f < 4; ++f) {
    numbers.insert(polyhedron.face(f).number);
  }
  EXPECT_EQ(numbers, (std::multiset<int>{1, 2, 3, 5}));  // the second cut took away the first one's face
}

TEST(Polyhedra, StayWholeOutsideOfPlanesAndBecomeEmptyBeyondThem) {
  EXPECT_EQ(cut({below(Vector3::UnitX(), 1.0)}).face_count(), 4U);  // touches a corner
  EXPECT_EQ(cut({below(Vector3::UnitX(), 2.0)}).face_count(), 4U);
  EXPECT_EQ(cut({below(-Vector3::UnitX(), 0.0)}).face_count(), 4U);  // lies in a face
  const Polyhedron nothing = cut({below(Vector3::UnitX(), -0.1)});
  EXPECT_TRUE(nothing.empty());
  EXPECT_EQ(nothing.moments().volume, 0.0);
  EXPECT_EQ(nothing.moments().first, Vector3::Zero());
}

TEST(Polyhedra, AreDividedByAPlaneWithoutRest) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<Plane> planes;
    for (int i = 0; i < trial % 5; ++i) {
      planes.push_back(below(Vector3(number(random), number(random), number(random)), 0.3 * number(random)));
    }
    const Plane last = below(Vector3(number(random), number(random), number(random)), 0.3 * number(random));
    const Plane reverse = {-last.normal, last.point};
    const Polyhedron::Moments whole = cut(planes).moments();
    planes.push_back(last);
    const Polyhedron one = cut(planes);
    planes.back() = reverse;
    const Polyhedron other = cut(planes);
    EXPECT_NEAR(one.moments().volume + other.moments().volume, whole.volume, 1e-14) << trial;
    EXPECT_LT((one.moments().first + other.moments().first - whole.first).norm(), 1e-14) << trial;
    EXPECT_LT(sum_of_faces(one).norm(), 1e-14) << trial;
  }
}

TEST(Tetrahedra, HaveBarycentricCoordinates) {
  const Tetrahedron tetrahedron({Vector3(1, 0, 0), Vector3(2, 0.3, 0), Vector3(0.5, 1.5, 0.1), Vector3(1, 0.4, 0.9)});
  EXPECT_GT(tetrahedron.volume, 0.0);
  const Eigen::Vector4d share(0.1, 0.2, 0.3, 0.4);
  Vector3 place = Vector3::Zero();
  for (std::size_t i = 0; i < 4; ++i) {
    place += share[static_cast<Eigen::Index>(i)] * tetrahedron.corners.at(i);
    // A corner's coordinate falls to 0 at the opposite face, whose plane has the other corners on it.
    EXPECT_NEAR(tetrahedron.plane(i).distance(tetrahedron.corners.at(i)), -1 / tetrahedron.gradients.at(i).norm(),
                1e-14);
    for (const Vector3& on_face : tetrahedron.face(i)) {
      EXPECT_NEAR(tetrahedron.plane(i).distance(on_face), 0.0, 1e-14);
    }
    const auto [a, b, c] = tetrahedron.face(i);
    EXPECT_GT((b - a).cross(c - a).dot(tetrahedron.plane(i).normal), 0.0);
  }
  EXPECT_LT((tetrahedron.coordinates(place) - share).norm(), 1e-14);
}

}  // namespace
}  // namespace idiophone::contact
