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

TEST(Type, OfNoKnownKindIsAnError) {
  EXPECT_THROW(unknown_kind(), std::logic_error);
}

}  // namespace
}  // namespace idiophone::element
