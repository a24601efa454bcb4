#include "space_filling_curve.hpp"
#include "ranks.hpp"

#include <gtest/gtest.h>

namespace idiophone::mesh {
namespace {

ON_RANKS(1);

TEST(SpaceFillingCurve, VisitsAGridInStepsOfOneCell) {
  std::vector<Vector3> grid;
  constexpr int cells = 8 * 8 * 8;
  grid.reserve(cells);
  for (int i = 0; i < cells; ++i) {
    grid.emplace_back(i / 64, i / 8 % 8, i % 8);
  }
  const auto order = curve_order(grid);
  ASSERT_EQ(order.size(), grid.size());
  for (std::size_t i = 1; i < order.size(); ++i) {
    const auto from = static_cast<std::size_t>(order[i - 1]);
    const auto to = static_cast<std::size_t>(order[i]);
    EXPECT_DOUBLE_EQ((grid[to] - grid[from]).norm(), 1.0) << "step " << i;
  }
}

TEST(SpaceFillingCurve, BreaksTiesByNumber) {
  EXPECT_EQ(curve_order({Vector3::Ones(), Vector3::Ones(), Vector3::Ones()}), (std::vector<Index>{0, 1, 2}));
  EXPECT_EQ(curve_order({Vector3::Ones(), Vector3::Zero(), Vector3::Ones()}), (std::vector<Index>{1, 0, 2}));
  EXPECT_TRUE(curve_order({}).empty());
}

}  // namespace
}  // namespace idiophone::mesh
