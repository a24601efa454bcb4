#include "idiophone/run/loop/run_loop.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>

#include "blocks.hpp"
#include "idiophone/foundation/parallel/broadcast.hpp"
#include "idiophone/foundation/parallel/clock.hpp"
#include "idiophone/foundation/parallel/reduce.hpp"
#include "idiophone/run/loop/stop.hpp"
#include "idiophone/run/record/sound.hpp"

namespace idiophone::loop {

RunLoop::RunLoop(const Participants& participants, const Extent& extent, MPI_Comm communicator)
    : participants_(participants), extent_(extent), communicator_(communicator), longest_block_(loop::longest_block) {
  for (const auto& recorder : participants_.recorders) {
    longest_block_ = std::min(longest_block_, recorder->longest_block());
  }
}

void RunLoop::start() {
  record::declare_sound(participants_.audio_path, participants_.result);
  participants_.source.start(motion_);
  participants_.audio_path.start(motion_);
  for (const auto& recorder : participants_.recorders) {
    recorder->declare();
    recorder->note(participants_.source.first_sample(), motion_);
  }
}

bool RunLoop::run(const std::optional<double>& wall_clock_limit, CheckpointSchedule* checkpoints, Progress& progress) {
  const double started = parallel::wall_time();
  for (const auto& recorder : participants_.recorders) {
    recorder->begin();
  }
  const std::int64_t first = first_block(extent_.steps_per_sample, extent_.nodes);
  Decision decision{std::max(first, participants_.source.samples_before_archive()), 0, 0};
  while (advanced_ < extent_.samples && decision.stop == 0) {
    const double block_start = parallel::wall_time();
    const std::int64_t block = std::min(decision.next_block, extent_.samples - advanced_);
    advance_block(block);
    finish_block();
    const double now = parallel::wall_time();
    decision.next_block = next_block(block, now - block_start, longest_block_);
    decision.stop = wall_clock_limit && now - started > *wall_clock_limit ? 1 : 0;
    decision.checkpoint = checkpoints != nullptr && checkpoints->due() ? 1 : 0;
    decision = agree(decision);
    if (checkpoints != nullptr && (decision.checkpoint != 0 || decision.stop != 0)) {
      write_checkpoint(*checkpoints);
    }
    progress.report(
        advanced_,
        fmt::format("loudest {:.3g}{}", participants_.audio_path.loudest(),
                    checkpoints != nullptr ? fmt::format("  checkpoints {}", checkpoints->written()) : std::string()));
  }
  return advanced_ == extent_.samples;
}

void RunLoop::advance_block(std::int64_t samples) {
  const parallel::NoCollectives no_collectives;
  for (std::int64_t i = 0; i < samples; ++i) {
    advance_sample();
  }
}

void RunLoop::advance_sample() {
  participants_.source.advance(motion_);
  ++advanced_;
  participants_.audio_path.hear(motion_);
  const parallel::Stages::Scope stage(participants_.stages, parallel::Stage::store);
  for (const auto& recorder : participants_.recorders) {
    recorder->note(participants_.source.first_sample() + advanced_, motion_);
  }
}

void RunLoop::finish_block() {
  const parallel::Stages::Scope stage(participants_.stages, parallel::Stage::store);
  participants_.source.check();
  participants_.audio_path.check();
  for (const auto& recorder : participants_.recorders) {
    recorder->write();
  }
  record::write_sound(participants_.audio_path, extent_.sound_samples, participants_.result);
  participants_.result.flush();
}

RunLoop::Decision RunLoop::agree(Decision decision) const {
  const int signal = parallel::largest(noted_signal(), communicator_);
  if (parallel::is_root(communicator_)) {
    decision.stop = advanced_ < extent_.samples && (signal != 0 || decision.stop != 0) ? 1 : 0;
    if (decision.stop != 0) {
      spdlog::info("stopping in good order: {}", signal == asked_by_host ? "as the host program asks"
                                                 : signal != 0           ? fmt::format("signal {}", signal)
                                                                         : "wall-clock limit");
    }
  }
  parallel::broadcast(decision, communicator_);
  return decision;
}

void RunLoop::write_checkpoint(CheckpointSchedule& checkpoints) {
  const parallel::Stages::Scope stage(participants_.stages, parallel::Stage::store);
  checkpoints.write({advanced_ * extent_.steps_per_sample, advanced_},
                    [this](parallel::Archive& archive) { this->archive(archive); });
  participants_.result.flush();
}

void RunLoop::archive(parallel::Archive& archive) {
  archive.root("run/advanced", advanced_);
  participants_.result.archive(archive);
  for (const auto& recorder : participants_.recorders) {
    recorder->archive(archive);
  }
  participants_.source.archive(archive);
  participants_.audio_path.archive(archive);
}

}  // namespace idiophone::loop
