#include "idiophone/run/loop/checkpoint_schedule.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <stdexcept>

#include "idiophone/foundation/parallel/clock.hpp"
#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/run/results/checkpoint_archive.hpp"

namespace idiophone::loop {

CheckpointSchedule::CheckpointSchedule(std::filesystem::path directory, results::Identity identity,
                                       const scene::Output& output, MPI_Comm communicator)
    : directory_(std::move(directory)),
      identity_(std::move(identity)),
      interval_(60 * output.checkpoint_minutes),
      keep_(output.checkpoint_keep),
      communicator_(communicator),
      last_(parallel::wall_time()) {}

bool CheckpointSchedule::due() const {
  return interval_ > 0 && parallel::wall_time() - last_ > interval_;
}

void CheckpointSchedule::write(const results::Moment& moment, const ArchiveState& archive_state) {
  results::CheckpointWriter writer(directory_, identity_, moment, communicator_);
  results::SavingArchive archive(writer, communicator_);
  archive_state(archive);
  const std::filesystem::path path = writer.commit(keep_);
  last_ = parallel::wall_time();
  ++written_;
  if (parallel::is_root(communicator_)) {
    spdlog::info("checkpoint {} at audio sample {}", path.string(), moment.sample);
  }
}

std::optional<results::CheckpointReader> CheckpointSchedule::find(
    const std::vector<results::ContinuedFile>& files) const {
  results::CheckpointSearch search = results::find_checkpoint(directory_, identity_, files, communicator_);
  const bool reports = parallel::is_root(communicator_);
  for (const auto& [path, reason] : search.refused) {
    if (reports) {
      spdlog::warn("checkpoint {} refused: {}", path.string(), reason);
    }
  }
  for (const std::string& path : search.rebuilt) {
    if (reports) {
      spdlog::warn("{} was damaged after the checkpoint; it was rebuilt up to there, and the rest is computed again",
                   path);
    }
  }
  if (!search.checkpoint && !search.refused.empty()) {
    const auto& [path, reason] = search.refused.front();
    throw std::runtime_error(fmt::format(
        "none of the checkpoints in {} can be resumed from; {}: {}; bring back what is damaged or missing, or, "
        "to start again from the beginning, leave --resume out",
        directory_.string(), path.filename().string(), reason));
  }
  if (!search.checkpoint && reports) {
    spdlog::info("no checkpoint in {}: starting from the beginning", directory_.string());
  }
  return std::move(search.checkpoint);
}

}  // namespace idiophone::loop
