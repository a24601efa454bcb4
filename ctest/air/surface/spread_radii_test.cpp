#include "idiophone/air/surface/spread_radii.hpp"

#include <gmock/gmock.h>

#include "idiophone/air/surface/equivalent_radius.hpp"
#include "ranks.hpp"

namespace idiophone::surface {
namespace {

using ::testing::ElementsAre;

constexpr std::array<Index, 4> first_triangle = {0, 4, 8, 12};  // three bodies

/// The four faces of a tetrahedron, the larger the higher its number: edges of 1, 2 and 3 m, and more along z.
std::vector<std::array<Vector3, 3>> tetrahedron(std::size_t body) {
  const auto size = static_cast<double>(body + 1);
  const Vector3 o = Vector3::Zero(), x(size, 0, 0), y(0, size, 0), z(0, 0, 2 * size);
  return {{o, y, x}, {o, x, z}, {o, z, y}, {x, y, z}};
}

ON_RANKS(1);

TEST(SpreadRadii, GivesEachTriangleTheRadiusOnItsOwnBody) {
  const std::vector<Index> triangles = {1, 3, 8, 11};
  const std::vector<double> radii = spread_radii(triangles, first_triangle, tetrahedron);
  const std::vector<double> small = surface::equivalent_radii(tetrahedron(0), std::vector<Index>{1, 3});
  const std::vector<double> large = surface::equivalent_radii(tetrahedron(2), std::vector<Index>{0, 3});
  EXPECT_THAT(radii, ElementsAre(small[0], small[1], large[0], large[1]));
  EXPECT_NEAR(large[1], 3 * small[1], 1e-12);
}

TEST(SpreadRadii, TrianglesInsideABodyDoNotChangeThoseOutside) {
  constexpr std::array<Index, 2> one_body = {0, 6};
  const auto with_inner_pair = [](std::size_t body) {
    auto all = tetrahedron(body);
    const Vector3 a(0.2, 0.2, 0.2), b(0.4, 0.2, 0.2), c(0.2, 0.4, 0.2);
    all.push_back({a, b, c});
    all.push_back({a, c, b});
    return all;
  };
  const std::vector<Index> triangles = {1, 3, 4, 5};
  const auto radii = spread_radii(triangles, one_body, with_inner_pair, std::array<std::size_t, 1>{2});
  const auto outer = equivalent_radii(tetrahedron(0), std::vector<Index>{1, 3});
  const auto inner = equivalent_radii(with_inner_pair(0), std::vector<Index>{4, 5});
  EXPECT_THAT(radii, ElementsAre(outer[0], outer[1], inner[0], inner[1]));
  EXPECT_NE(equivalent_radii(with_inner_pair(0), std::vector<Index>{3})[0], outer[1]);
}

TEST(SpreadRadii, AsksForEveryBodyOnceInOrder) {
  std::vector<std::size_t> asked;
  const std::vector<Index> triangles = {5};
  const auto radii = spread_radii(triangles, first_triangle, [&](std::size_t body) {
    asked.push_back(body);
    return tetrahedron(body);
  });
  EXPECT_EQ(radii.size(), 1U);
  EXPECT_THAT(asked, ElementsAre(0, 1, 2));
}

}  // namespace
}  // namespace idiophone::surface
