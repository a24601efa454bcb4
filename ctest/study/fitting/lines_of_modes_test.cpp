#include "idiophone/study/fitting/lines_of_modes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "ranks.hpp"

namespace idiophone::fitting {
namespace {

ON_RANKS(1);

TEST(LinesOfModes, AreFoundThoughTheBodyIsLower) {
  const std::vector<double> modes = {200, 430, 800, 900, 2000};
  const double lower = std::exp2(-230.0 / 1200);
  // Mode 4 has no line, and 1200 Hz is no mode.
  const std::vector<Line> lines = {{lower * 200 * 1.01}, {lower * 430}, {lower * 800 * 0.99}, {1200}, {lower * 2000}};
  const LinesOfModes found = lines_of_modes(modes, lines, 60);
  EXPECT_NEAR(found.shift, -230, 15);
  for (const std::size_t mode : {0U, 1U, 2U}) {
    ASSERT_TRUE(found.lines[mode]);
    EXPECT_EQ(found.lines[mode]->frequency, lines[mode].frequency);
  }
  EXPECT_FALSE(found.lines[3]);
  EXPECT_EQ(found.lines[4].value().frequency, lines[4].frequency);
}

}  // namespace
}  // namespace idiophone::fitting
