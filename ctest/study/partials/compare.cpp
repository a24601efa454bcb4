#include "idiophone/study/partials/compare.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

namespace idiophone::partials {
namespace {

const std::vector<Partial> two_partials = {{.frequency = 101.0, .level = -3.0, .decay_time = 1.25},
                                           {.frequency = 198.0, .level = -10.5, .decay_time = std::nullopt}};

TEST(Compare, CentsAreHundredthsOfASemitone) {
  EXPECT_DOUBLE_EQ(cents(880.0, 440.0), 1200.0);
  EXPECT_NEAR(cents(440.0, 466.1637615), -100.0, 1e-6);
}

TEST(Compare, EachReferenceGetsItsNearestPartial) {
  const auto matches = match(two_partials, {.name = "theory", .frequencies = {100.0, 200.0, 203.0, 300.0}});
  ASSERT_EQ(matches.size(), 4);
  EXPECT_EQ(matches[0].partial, 0);
  EXPECT_NEAR(matches[0].percent, 1.0, 1e-12);
  EXPECT_NEAR(matches[0].cents, 17.226, 1e-3);
  EXPECT_EQ(matches[1].partial, 1);
  EXPECT_NEAR(matches[1].percent, -1.0, 1e-12);
  EXPECT_EQ(matches[2].partial, 1) << "two references may share a partial";
  EXPECT_FALSE(matches[3].partial.has_value());
}

TEST(Compare, TheToleranceCounts) {
  const References references{.name = "theory", .frequencies = {100.0}};
  EXPECT_TRUE(match(two_partials, references, 18.0)[0].partial.has_value());
  EXPECT_FALSE(match(two_partials, references, 17.0)[0].partial.has_value());
}

TEST(Compare, NoPartialsMatchNothing) {
  EXPECT_FALSE(match({}, {.name = "theory", .frequencies = {100.0}})[0].partial.has_value());
}

TEST(Compare, TheTableHasAColumnForEachSetOfReferences) {
  const std::vector<References> sets = {{.name = "thin plate (Leissa)", .frequencies = {100.0, 300.0}},
                                        {.name = "solid", .frequencies = {100.5, 198.0}}};
  EXPECT_EQ(table(two_partials, sets),
            "frequency/Hz   level/dB     T60/s  thin plate (Leissa)     solid\n"
            "      101.00      -3.00     1.250                +17.2      +8.6\n"
            "      198.00     -10.50         -                    -      +0.0\n"
            "no partial within 100 cents of 300.00 Hz (thin plate (Leissa))\n");
}

TEST(Compare, CentsAreThoseFromTheNearestReference) {
  const References references{.name = "theory", .frequencies = {90.0, 100.0, 110.0}};
  EXPECT_DOUBLE_EQ(cents_from_nearest(101.0, references, 100.0).value(), cents(101.0, 100.0));
  EXPECT_FALSE(cents_from_nearest(104.0, references, 50.0).has_value());
}

TEST(Compare, WithoutReferencesTheTableIsNarrow) {
  EXPECT_TRUE(table(two_partials).starts_with("frequency/Hz   level/dB     T60/s\n"));
}

TEST(Compare, WrongInputIsRefused) {
  EXPECT_THROW((void)match(two_partials, {.name = "theory", .frequencies = {0.0}}), std::invalid_argument);
  EXPECT_THROW((void)match(two_partials, {.name = "theory", .frequencies = {std::numeric_limits<double>::quiet_NaN()}}),
               std::invalid_argument);
  EXPECT_THROW((void)table(two_partials, std::vector<References>{{.name = "theory", .frequencies = {100.0}}}, 0.0),
               std::invalid_argument);
}

}  // namespace
}  // namespace idiophone::partials
