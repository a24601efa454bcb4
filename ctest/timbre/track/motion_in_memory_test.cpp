// Motion channels of a run that begins and of one in memory.

#include <gmock/gmock.h>

#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/timbre/track/motion_channels.hpp"
#include "ranks.hpp"

namespace idiophone::timbre {
namespace {

using ::testing::ElementsAre;

const std::vector<spectra::Series> channels_of_coin = {{"/contacts/hit/force", "N", 4.0, {"force"}, "", {}},
                                                       {"/motion/coin/velocity", "m/s", 2.0, {"x", "y"}, "", {}}};

}  // namespace

ON_RANKS(1);

TEST(MotionInMemory, HasTheRowsOfItsChannels) {
  const MotionRows rows = {{"/motion/coin/velocity", {3, 4, 0, -2}}};
  const MotionChannels motion(channels_of_coin, rows);
  const ChannelValues column = motion.values({.channel = "motion/coin/velocity", .column = "y", .where = {}});
  EXPECT_EQ(column.rate, 2.0);
  EXPECT_THAT(column.values, ElementsAre(4, -2));
  EXPECT_THAT(motion.values({.channel = "motion/coin/velocity", .where = {}}).values, ElementsAre(5, 2));
}

TEST(MotionInMemory, HasTheDerivativesOfItsChannels) {
  const MotionRows rows = {{"/motion/coin/velocity", {3, 4, 0, -2, 1, 7}}};
  const MotionChannels motion(channels_of_coin, rows);
  const MotionVariable variable{.channel = "motion/coin/velocity",
                                .column = "y",
                                .mapping = {.offset = 1, .range = {}},
                                .derivative = true,
                                .where = {}};
  EXPECT_THAT(motion.values(variable).values, ElementsAre(-11, 4, 19));  // 2 rows a second
  const MotionRows single = {{"/motion/coin/velocity", {3, 4}}};
  EXPECT_THAT(MotionChannels(channels_of_coin, single).values(variable).values, ElementsAre(1));
}

TEST(MotionInMemory, FindsItsContacts) {
  const MotionRows rows = {{"/contacts/hit/force", {0, 8, 4, 0, 0, 0, 0, 2}}};
  const auto events =
      MotionChannels(channels_of_coin, rows).contacts({.contact = "hit", .above = 1.0, .gap = 0.3, .where = {}});
  ASSERT_EQ(events.size(), 2U);
  EXPECT_EQ(events[0].time, 0.25);
  EXPECT_EQ(events[0].force, 8);
  EXPECT_EQ(events[0].impulse, 3);
  EXPECT_EQ(events[1].time, 1.75);
}

TEST(MotionOfARunThatBegins, NamesTheChannelsThatAreNeeded) {
  std::set<std::string> named;
  const MotionChannels motion(channels_of_coin, named);
  EXPECT_THAT(motion.values({.channel = "motion/coin/velocity", .where = {}}).values, ElementsAre(0));
  EXPECT_THAT(named, ElementsAre("/motion/coin/velocity"));
  const auto events = motion.contacts({.contact = "hit", .above = 2.0, .where = {}});
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0].force, 2.0);
  EXPECT_THAT(named, ElementsAre("/contacts/hit/force", "/motion/coin/velocity"));
  EXPECT_THROW((void)motion.values({.channel = "motion/coin/place", .where = {}}), deck::DeckError);
}

}  // namespace idiophone::timbre
