#include "idiophone/foundation/deck/location.hpp"

#include <gtest/gtest.h>

namespace idiophone::deck {

TEST(Location, IsWrittenAsCompilersWriteIt) {
  EXPECT_EQ(to_string({"deck.yaml", 3, 14}), "deck.yaml:3:14");
}

TEST(DeckError, HasALineForEachMistake) {
  const DeckError error({{{"deck.yaml", 3, 14}, "one"}, {{"--set a=b", 1, 1}, "two"}});
  EXPECT_STREQ(error.what(), "deck.yaml:3:14: one\n--set a=b:1:1: two");
}

}  // namespace idiophone::deck
