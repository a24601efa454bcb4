#include "idiophone/run/loop/progress.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>

#include "idiophone/foundation/parallel/clock.hpp"
#include "idiophone/run/loop/stop.hpp"

namespace idiophone::loop {

namespace {

constexpr double log_interval = 10.0;  // s between the lines of a log

std::string clock_text(double seconds) {
  const auto whole = std::llround(std::max(0.0, seconds));
  return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

/// @param is_last  a line that is updated ends
void show(const std::string& text, ProgressStyle style, bool is_last) {
  if (style == ProgressStyle::line) {
    fmt::print("\r\033[K{}{}", text, is_last ? "\n" : "");
    std::fflush(stdout);
  } else {
    spdlog::info("{}", text);
  }
}

}  // namespace

Progress::Progress(Task task, std::int64_t done, ProgressStyle style)
    : task_(std::move(task)),
      resumed_at_(done),
      style_(style),
      start_(parallel::wall_time()),
      start_of_processor_(std::clock()) {}

void Progress::report(std::int64_t done, const std::string& remark) {
  const double now = parallel::wall_time();
  const bool last = done >= task_.samples;
  if (style_ == ProgressStyle::silent || (style_ == ProgressStyle::log && now - reported_ < log_interval && !last)) {
    return;
  }
  reported_ = now;
  const double samples_per_second = static_cast<double>(done - resumed_at_) / (now - start_);
  const std::string text =
      fmt::format("{:5.1f} %  {:.4f} s  {:.0f} {}/s  {} left  {}",
                  100.0 * static_cast<double>(done) / static_cast<double>(task_.samples),
                  static_cast<double>(done) / task_.rate, samples_per_second * task_.parts, task_.parts_name,
                  clock_text(static_cast<double>(task_.samples - done) / samples_per_second), remark);
  show(text, style_, last);
}

double Progress::elapsed() const {
  return parallel::wall_time() - start_;
}

double Progress::processor_time() const {
  return static_cast<double>(std::clock() - start_of_processor_) / CLOCKS_PER_SEC;
}

void Progress::conclude(const std::string& speed, const parallel::Stages& stages) const {
  if (style_ == ProgressStyle::silent) {
    return;
  }
  spdlog::info("{} of computing, {}", clock_text(elapsed()), speed);
  std::string shares;
  for (std::size_t stage = 0; stage < parallel::stage_count; ++stage) {
    if (const double seconds = stages.seconds(static_cast<parallel::Stage>(stage)); seconds != 0.0) {
      shares += fmt::format("  {} {:.1f} %", parallel::stage_names[stage], 100 * seconds / stages.total());
    }
  }
  spdlog::info("share of time on rank 0:{}", shares);
}

PieceProgress::PieceProgress(std::string pieces, ProgressStyle style)
    : pieces_(std::move(pieces)), style_(style), start_(parallel::wall_time()), reported_(start_) {}

PieceProgress::~PieceProgress() {
  if (has_open_line_) {
    std::fputs("\n", stdout);
  }
}

bool PieceProgress::report(int done, int expected, const std::string& remark) {
  watch_signals(OnSignal::note);
  const double now = parallel::wall_time();
  const bool is_due = style_ == ProgressStyle::line || now - reported_ >= log_interval;
  if (style_ != ProgressStyle::silent && is_due) {
    reported_ = now;
    has_open_line_ = style_ == ProgressStyle::line;
    const double left = (now - start_) / done * (expected - done);
    show(fmt::format("{} of about {} {}, {} left  {}", done, expected, pieces_, clock_text(left), remark), style_,
         false);
  }
  return noted_signal() == 0;
}

ProgressStyle progress_style(ProgressWish wish, int rank) {
  if (rank != 0) {
    return ProgressStyle::silent;
  }
  const bool own_terminal = isatty(STDOUT_FILENO) != 0 && std::getenv("OMPI_COMM_WORLD_SIZE") == nullptr;
  return wish == ProgressWish::line || (wish == ProgressWish::automatic && own_terminal) ? ProgressStyle::line
                                                                                         : ProgressStyle::log;
}

}  // namespace idiophone::loop
