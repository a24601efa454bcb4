#include "progress.hpp"

#include <fmt/format.h>
#include <mpi.h>
#include <spdlog/spdlog.h>

#include <cmath>

namespace idiophone::app {

namespace {

constexpr double log_interval = 10.0;  // s between the lines of a log

std::string clock_text(double seconds) {
  const auto whole = std::llround(std::max(0.0, seconds));
  return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

}  // namespace

Progress::Progress(const Preparation& ready, std::int64_t last_sample, std::int64_t done, bool line, bool speaks)
    : ready_(ready), last_sample_(last_sample), resumed_at_(done), speaks_(speaks), line_(line), start_(MPI_Wtime()) {}

void Progress::tell(std::int64_t done, double loudest, int checkpoints) {
  const double now = MPI_Wtime();
  const bool last = done >= last_sample_;
  if (!speaks_ || (!line_ && now - told_ < log_interval && !last)) {
    return;
  }
  told_ = now;
  const double samples_per_second = static_cast<double>(done - resumed_at_) / (now - start_);
  const std::string text =
      fmt::format("{:5.1f} %  {:.4f} s  {:.0f} steps/s  {} left  loudest {:.3g}  checkpoints {}",
                  100.0 * static_cast<double>(done) / static_cast<double>(last_sample_),
                  static_cast<double>(done) / ready_.scene.audio.rate, samples_per_second * ready_.steps_per_sample,
                  clock_text(static_cast<double>(last_sample_ - done) / samples_per_second), loudest, checkpoints);
  if (line_) {
    fmt::print("\r\033[K{}{}", text, last ? "\n" : "");
    std::fflush(stdout);
  } else {
    spdlog::info("{}", text);
  }
}

void Progress::conclude(std::int64_t done, const Stages& stages, int ranks) const {
  if (!speaks_) {
    return;
  }
  const double elapsed = MPI_Wtime() - start_;
  const double steps = static_cast<double>(done - resumed_at_) * ready_.steps_per_sample;
  spdlog::info("{} of computing, {:.4g} million elements a second and core, everything included", clock_text(elapsed),
               steps * ready_.part.global_elements / elapsed / ranks / 1e6);
  std::string shares;
  for (std::size_t stage = 0; stage < stage_count; ++stage) {
    if (static_cast<Stage>(stage) == Stage::contact && ready_.scene.contacts.empty()) {
      continue;
    }
    shares += fmt::format("  {} {:.1f} %", stage_names[stage],
                          100 * stages.seconds(static_cast<Stage>(stage)) / stages.total());
  }
  spdlog::info("share of time on rank 0:{}", shares);
}

}  // namespace idiophone::app
