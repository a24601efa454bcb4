#include "idiophone/run/results/contact_spread.hpp"

#include <gmock/gmock.h>

#include <array>

#include "ranks.hpp"

namespace idiophone::results {
namespace {

ON_RANKS(1);

TEST(ContactSpread, ComesBackFromItsRow) {
  const Eigen::Matrix3d spread{{1, 4, 5}, {4, 2, 6}, {5, 6, 3}};
  EXPECT_THAT(spread_row(spread), testing::ElementsAre(1, 2, 3, 4, 5, 6));
  EXPECT_EQ(spread_of_row(spread_row(spread)), spread);
  EXPECT_THAT(spread_column_names(), testing::ElementsAre("xx", "yy", "zz", "xy", "xz", "yz"));
  EXPECT_THROW(static_cast<void>(spread_of_row(std::array{1.0, 2.0, 3.0})), std::runtime_error);
}

}  // namespace
}  // namespace idiophone::results
