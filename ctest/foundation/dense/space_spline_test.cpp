#include "idiophone/foundation/dense/space_spline.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace idiophone::dense {
namespace {

double value_at(const std::vector<Vector3>& points, const std::vector<double>& values, const Vector3& place) {
  const Eigen::MatrixXd weights = spline_weights(points, std::vector<Vector3>{place});
  double sum = 0.0;
  for (std::size_t k = 0; k < values.size(); ++k) {
    sum += weights(0, static_cast<Eigen::Index>(k)) * values[k];
  }
  EXPECT_NEAR(SpaceSpline(points, values)(place), sum, 1e-9 * (1 + std::abs(sum)));
  return sum;
}

TEST(SpaceSpline, OfPointsOnALineIsTheNaturalCubicSpline) {
  // Through 0, 1, 0 at 0, 1, 2: (3 x - x^3)/2 up to 1.
  const std::vector<Vector3> points = {{0, 1, 2}, {1, 1, 2}, {2, 1, 2}};
  for (const double x : {0.0, 0.25, 0.5, 1.0}) {
    EXPECT_NEAR(value_at(points, {0, 1, 0}, {x, 1, 2}), (3 * x - x * x * x) / 2, 1e-12) << x;
  }
}

TEST(SpaceSpline, HasLinearFunctionsExactly) {
  const std::vector<Vector3> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
  std::vector<double> values;
  for (const Vector3& point : points) {
    values.push_back(2 + point.dot(Vector3(1, -3, 0.5)));
  }
  EXPECT_NEAR(value_at(points, values, {3, 0.2, -4}), 2 + 3 - 0.6 - 2, 1e-10);
}

TEST(SpaceSpline, TakesNoSlopeAcrossAPlateFromPointsThatAreMeasuredBadly) {
  std::vector<Vector3> points;
  std::vector<double> values;
  for (int i = 0; i < 16; ++i) {
    points.emplace_back(i % 4, i / 4, 1e-3 * (i % 3));  // a thousandth off the plane
    values.push_back(std::sin(i));
  }
  EXPECT_NEAR(value_at(points, values, {1.5, 1.5, 0.05}), value_at(points, values, {1.5, 1.5, 0}), 0.01);
}

TEST(SpaceSpline, AveragesBlowsAtOnePoint) {
  const std::vector<Vector3> points = {{0, 0, 0}, {1, 0, 0}, {1, 0, 0}};
  EXPECT_NEAR(value_at(points, {1, 2, 4}, {1, 0, 0}), 3, 1e-12);
  EXPECT_NEAR(value_at({Vector3(5, 5, 5)}, {7}, {1, 0, 0}), 7, 1e-12);
}

}  // namespace
}  // namespace idiophone::dense
