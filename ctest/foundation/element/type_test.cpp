#include "idiophone/foundation/element/type.hpp"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

namespace idiophone::element {
namespace {

TEST(Type, HasANameOfItsOwn) {
  std::set<std::string_view> names;
  for (const Type type : types()) {
    names.insert(name(type));
  }
  EXPECT_EQ(names, (std::set<std::string_view>{"tet4", "tet10", "hex"}));
}

TEST(Type, KnowsItsNodes) {
  EXPECT_EQ(node_count(tet4), 4);
  EXPECT_EQ(node_count(tet10), 10);
  EXPECT_EQ(node_count(hex(4, 2)), 75);
}

TEST(Type, KnowsItsOrders) {
  EXPECT_EQ(orders(tet4).plane, 1);
  EXPECT_EQ(orders(tet10).thickness, 2);
  EXPECT_EQ(orders(hex(4, 2)).plane, 4);
  EXPECT_EQ(orders(hex(4, 2)).thickness, 2);
  EXPECT_EQ(with_orders(hex(4, 4), {3, 2}), hex(3, 2));
  EXPECT_EQ(with_orders(tet10, {3, 2}), tet10);
}

TEST(Type, HasLinesThroughTheThicknessWhereItIsSwept) {
  EXPECT_EQ(lines_through(tet4), 0);
  EXPECT_EQ(lines_through(tet10), 0);
  EXPECT_EQ(lines_through(hex(4, 2)) * 3, node_count(hex(4, 2)));
}

TEST(Type, OfNoKnownKindIsAnError) {
  EXPECT_THROW(unknown_kind(), std::logic_error);
}

}  // namespace
}  // namespace idiophone::element
