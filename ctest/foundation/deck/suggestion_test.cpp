#include "idiophone/foundation/deck/suggestion.hpp"

#include <gtest/gtest.h>

namespace idiophone::deck {

TEST(EditDistance, CountsLettersInsertedDeletedAndExchanged) {
  EXPECT_EQ(edit_distance("", ""), 0U);
  EXPECT_EQ(edit_distance("young", ""), 5U);
  EXPECT_EQ(edit_distance("", "young"), 5U);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
  EXPECT_EQ(edit_distance("Young", "young"), 0U);
}

TEST(Suggestion, IsTheNearestNameIfItIsNear) {
  const std::vector<std::string> known = {"stiffness", "damping", "density"};
  EXPECT_EQ(suggestion("densty", known), " (did you mean 'density'?)");
  EXPECT_EQ(suggestion("Damping", known), " (did you mean 'damping'?)");
  EXPECT_EQ(suggestion("colour", known), "");
  EXPECT_EQ(suggestion("damp", {"lamp", "damping_factor"}), " (did you mean 'damping_factor'?)");
  EXPECT_EQ(suggestion("anything", {}), "");
}

}  // namespace idiophone::deck
