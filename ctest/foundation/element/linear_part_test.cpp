#include "idiophone/foundation/element/linear_part.hpp"

#include <gtest/gtest.h>

namespace idiophone::element {
namespace {

class LinearPartTest : public ::testing::TestWithParam<Type> {
 protected:
  /// Calls visit(corners of the triangle, xi; values at them of the linear part of a function) for all triangles.
  template <class Function, class Visit>
  void for_each_triangle(const Function& function, const Visit& visit) const {
    const ReferenceElement& table = reference(GetParam());
    for (const Face& face : table.faces) {
      for (const auto& corners : face.triangles) {
        Eigen::VectorXd values(std::ssize(face.nodes));
        for (std::size_t n = 0; n < face.nodes.size(); ++n) {
          values[static_cast<Eigen::Index>(n)] = function(table.nodes[face.nodes[n]]);
        }
        std::array<Vector3, 3> places;
        for (std::size_t k = 0; k < 3; ++k) {
          places.at(k) = table.nodes[corners.at(k)];
        }
        visit(places, Vector3(linear_part(table, face, corners) * values));
      }
    }
  }
};

TEST_P(LinearPartTest, OfALinearFunctionIsTheFunction) {
  const auto linear = [](const Vector3& xi) { return 3.0 + 2.0 * xi[0] - xi[1] + 0.5 * xi[2]; };
  for_each_triangle(linear, [&](const auto& places, const Vector3& found) {
    for (int k = 0; k < 3; ++k) {
      EXPECT_NEAR(found[k], linear(places.at(k)), 1e-12);
    }
  });
}

TEST_P(LinearPartTest, HasTheIntegralOfAQuadraticFunction) {
  if (orders(GetParam()).plane < 2) {
    GTEST_SKIP() << "the element has no such functions";
  }
  const auto quadratic = [](const Vector3& xi) { return xi[0] * xi[0] - 2.0 * xi[1] * xi[1] + xi[1] * xi[2]; };
  for_each_triangle(quadratic, [&](const auto& places, const Vector3& found) {
    double mean = 0.0;  // the rule of the middles of the edges is exact
    for (std::size_t k = 0; k < 3; ++k) {
      mean += quadratic((places.at(k) + places.at((k + 1) % 3)) / 2.0) / 3.0;
    }
    EXPECT_NEAR(found.mean(), mean, 1e-12);
  });
}

INSTANTIATE_TEST_SUITE_P(Types, LinearPartTest, ::testing::Values(tet4, tet10, hex(2, 2), hex(5, 3)));

}  // namespace
}  // namespace idiophone::element
