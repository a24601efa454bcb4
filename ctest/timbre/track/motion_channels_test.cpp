#include "idiophone/timbre/track/motion_channels.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "idiophone/foundation/deck/location.hpp"
#include "motion_curve.hpp"
#include "ranks.hpp"
#include "recorded_motion.hpp"

namespace idiophone::timbre {

namespace {

const deck::Location place{"s.yaml", 3, 4};

MotionVariable speed(const std::string& column = "") {
  return {.channel = "motion/ball/velocity", .column = column, .where = place};
}

template <class Action>
std::string mistake_of(const Action& action) {
  try {
    static_cast<void>(action());
  } catch (const deck::DeckError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

ON_RANKS(1);

TEST(MotionChannels, GiveAColumnOrTheLengthOfAllColumns) {
  const RecordedMotion recorded;
  const MotionChannels motion(recorded.path());
  const ChannelValues along = motion.values(speed("y"));
  EXPECT_EQ(along.rate, 100.0);
  ASSERT_EQ(along.values.size(), 100U);
  EXPECT_EQ(along.values[50], 1.0);
  EXPECT_NEAR(motion.values(speed()).values[50], 1.5, 1e-15);  // sqrt(1 + 4 + 4) t
}

TEST(MotionChannels, MapWhatTheyGive) {
  const RecordedMotion recorded;
  MotionVariable variable = speed("x");
  variable.mapping = {.scale = 4.0, .offset = -1.0, .curve = 2.0, .range = {{-0.5, 1.0}}};
  const std::vector<double> values = MotionChannels(recorded.path()).values(variable).values;
  EXPECT_EQ(values[0], -0.5);
  EXPECT_NEAR(values[60], 4.0 * 0.36 - 1.0, 1e-12);
  EXPECT_EQ(values[99], 1.0);
}

TEST(MotionChannels, NameTheNearestChannelAndColumn) {
  const RecordedMotion recorded;
  const MotionChannels motion(recorded.path());
  EXPECT_EQ(mistake_of([&] { return motion.values(speed("yy")); }),
            "s.yaml:3:4: /motion/ball/velocity has no column 'yy' (did you mean 'y'?)");
  MotionVariable variable = speed();
  variable.channel = "motion/ball/velocitie";
  EXPECT_NE(mistake_of([&] { return motion.values(variable); }).find("(did you mean '/motion/ball/velocity'?)"),
            std::string::npos);
  variable.channel = "motion/ball/nothing";
  EXPECT_EQ(mistake_of([&] { return motion.values(variable); }), "s.yaml:3:4: /motion/ball/nothing has no rows");
}

TEST(MotionChannels, NeedAResult) {
  const std::string message = "s.yaml:3:4: this needs the motion of a run; give its result NAME.h5 after the scene";
  EXPECT_EQ(mistake_of([&] { return MotionChannels({}).values(speed()); }), message);
  EXPECT_EQ(mistake_of([&] { return MotionChannels({}).contacts({.contact = "knock", .where = place}); }), message);
}

TEST(MotionChannels, RefuseMappingsThatAreNotFinite) {
  const RecordedMotion recorded;
  MotionVariable variable = speed("x");
  variable.mapping.curve = -1.0;  // of the first row, which is zero
  EXPECT_EQ(mistake_of([&] { return MotionChannels(recorded.path()).values(variable); }),
            "s.yaml:3:4: /motion/ball/velocity has values that are not finite");
}

TEST(MotionChannels, HaveAContactForEachRiseAboveAForce) {
  const RecordedMotion recorded;
  const auto contacts = MotionChannels(recorded.path()).contacts({.contact = "knock", .above = 2.0, .where = place});
  ASSERT_EQ(contacts.size(), 2U);
  EXPECT_EQ(contacts[0].time, 0.1);
  EXPECT_EQ(contacts[0].force, 3.0);
  EXPECT_NEAR(contacts[0].impulse, 0.06, 1e-15);
  EXPECT_EQ(contacts[1].time, 0.5);
  EXPECT_EQ(contacts[1].force, 8.0);
  EXPECT_NEAR(contacts[1].impulse, 0.08, 1e-15);
}

TEST(MotionChannels, JoinContactsWithAShorterGap) {
  const RecordedMotion recorded;
  const auto contacts =
      MotionChannels(recorded.path()).contacts({.contact = "knock", .above = 0.5, .gap = 0.5, .where = place});
  ASSERT_EQ(contacts.size(), 1U);
  EXPECT_NEAR(contacts[0].impulse, 0.15, 1e-15);
  EXPECT_TRUE(MotionChannels(recorded.path()).contacts({.contact = "knock", .above = 8.0, .where = place}).empty());
}

TEST(MotionCurves, AreChannelsOverTime) {
  const RecordedMotion recorded;
  const auto curve = curve_of(speed("y"), MotionChannels(recorded.path()));
  EXPECT_NEAR(curve->at(0.255), 0.51, 1e-12);
  MotionVariable held = speed("y");
  held.interpolation = Interpolation::hold;
  EXPECT_EQ(curve_of(held, MotionChannels(recorded.path()))->at(0.259), 0.5);
}

}  // namespace idiophone::timbre
