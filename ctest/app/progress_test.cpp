#include "progress.hpp"

#include <gmock/gmock.h>

namespace idiophone::app {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// What the reports of a task of 100 audio samples at 50 Hz print, one at the half and one at the end.
std::string printed(ProgressStyle style) {
  ::testing::internal::CaptureStdout();
  Progress progress({.samples = 100, .rate = 50, .parts = 10, .parts_name = "steps"}, 0, style);
  progress.report(50, "half");
  progress.report(100, "end");
  return ::testing::internal::GetCapturedStdout();
}

TEST(Progress, UpdatesOneLine) {
  const std::string text = printed(ProgressStyle::line);
  EXPECT_THAT(text, HasSubstr("\r\033[K 50.0 %  1.0000 s"));
  EXPECT_THAT(text, HasSubstr("steps/s"));
  EXPECT_TRUE(text.ends_with("end\n")) << text;
}

TEST(Progress, IsSilentOnOtherRanks) {
  EXPECT_THAT(printed(ProgressStyle::silent), IsEmpty());
}

TEST(ProgressStyle, IsTheUsersWishOnRankZero) {
  EXPECT_EQ(progress_style("line", 0), ProgressStyle::line);
  EXPECT_EQ(progress_style("log", 0), ProgressStyle::log);
  EXPECT_EQ(progress_style("line", 1), ProgressStyle::silent);
}

}  // namespace
}  // namespace idiophone::app
