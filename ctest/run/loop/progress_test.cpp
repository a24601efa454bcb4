#include "idiophone/run/loop/progress.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <spdlog/sinks/ostream_sink.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <sstream>

#include "ranks.hpp"
#include "stages.hpp"

namespace idiophone::loop {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

/// What the reports of a task of 100 audio samples at 50 Hz print, the last one at the end.
std::string printed(ProgressStyle style) {
  ::testing::internal::CaptureStdout();
  Progress progress({.samples = 100, .rate = 50, .parts = 10, .parts_name = "steps"}, 0, style);
  progress.report(50, "half");
  progress.report(70, "between");
  progress.report(100, "end");
  return ::testing::internal::GetCapturedStdout();
}

ON_RANKS(1);

TEST(Progress, UpdatesOneLine) {
  const std::string text = printed(ProgressStyle::line);
  EXPECT_THAT(text, HasSubstr("\r\033[K 50.0 %  1.0000 s"));
  EXPECT_THAT(text, HasSubstr("steps/s"));
  EXPECT_TRUE(text.ends_with("end\n")) << text;
}

/// What is logged meanwhile.
template <class Action>
std::string logged(const Action& action) {
  std::ostringstream text;
  const auto before = spdlog::default_logger();
  spdlog::set_default_logger(
      std::make_shared<spdlog::logger>("test", std::make_shared<spdlog::sinks::ostream_sink_st>(text)));
  spdlog::set_pattern("%v");
  action();
  spdlog::set_default_logger(before);
  return text.str();
}

TEST(Progress, LogsTheFirstBlockAndTheEndButNotEveryBlockBetween) {
  const std::string text = logged([] { EXPECT_THAT(printed(ProgressStyle::log), IsEmpty()); });
  EXPECT_THAT(text, AllOf(HasSubstr(" 50.0 %  1.0000 s"), HasSubstr("end\n"), Not(HasSubstr("between"))));
  EXPECT_EQ(std::ranges::count(text, '\n'), 2);
}

TEST(PieceProgress, ShowsTheBestSoFarInOneLine) {
  ::testing::internal::CaptureStdout();
  {
    PieceProgress progress("solves", ProgressStyle::line);
    EXPECT_TRUE(progress.report(1, 4, "first"));
    EXPECT_TRUE(progress.report(2, 4, "second"));
  }
  const std::string text = ::testing::internal::GetCapturedStdout();
  EXPECT_THAT(text, HasSubstr("\r\033[K1 of about 4 solves, 0:00:00 left  first\r"));
  EXPECT_TRUE(text.ends_with("second\n")) << text;
}

TEST(PieceProgress, EndsTheWorkAtASignal) {
  const auto work = [] {
    PieceProgress progress("solves", ProgressStyle::silent);
    const bool before = progress.report(1, 4, "");
    std::raise(SIGTERM);
    std::_Exit(before && !progress.report(2, 4, "") ? 0 : 1);
  };
  EXPECT_EXIT(work(), ::testing::ExitedWithCode(0), "");
}

TEST(Progress, ConcludesWithTheSpeedAndTheShares) {
  const auto conclude = [](ProgressStyle style) {
    { const parallel::Stages::Scope stage(support::stages(), parallel::Stage::radiation); }
    return logged([&] {
      Progress({.samples = 1, .parts_name = "steps"}, 0, style).conclude("7 elements a second", support::stages());
    });
  };
  const std::string said = conclude(ProgressStyle::log);
  const parallel::Stages& stages = support::stages();  // other tests of the program may have used some
  const double share = 100.0 * stages.seconds(parallel::Stage::radiation) / stages.total();
  EXPECT_THAT(said, AllOf(HasSubstr("0:00:00 of computing, 7 elements a second"),
                          HasSubstr(fmt::format("radiation {:.1f} %", share)), Not(HasSubstr("motion"))));
  EXPECT_THAT(conclude(ProgressStyle::silent), IsEmpty());
}

TEST(Progress, IsSilentOnOtherRanks) {
  EXPECT_THAT(printed(ProgressStyle::silent), IsEmpty());
}

TEST(ProgressStyle, IsTheUsersWishOnRankZero) {
  EXPECT_EQ(progress_style(ProgressWish::line, 0), ProgressStyle::line);
  EXPECT_EQ(progress_style(ProgressWish::log, 0), ProgressStyle::log);
  EXPECT_EQ(progress_style(ProgressWish::line, 1), ProgressStyle::silent);
}

}  // namespace
}  // namespace idiophone::loop
