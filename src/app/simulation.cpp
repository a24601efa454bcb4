#include "simulation.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "blocks.hpp"
#include "idiophone/surface/sampling.hpp"
#include "stop.hpp"

namespace idiophone::app {

namespace {

surface::Sampling sampling(const source::Preparation& ready) {
  const auto& audio = ready.scene.audio;
  return {audio.rate,          ready.steps_per_sample,   ready.steps_per_read,
          audio.max_frequency, audio.kernel_wavelengths, ready.scene.radiation.air.impedance()};
}

std::vector<Index> owned_node_ids(const mesh::Part& part) {
  return {part.node_ids.begin(), part.node_ids.begin() + part.owned_nodes};
}

}  // namespace

Simulation::Simulation(const source::Preparation& ready, const std::filesystem::path& directory, bool resume,
                       MPI_Comm communicator)
    : ready_(ready),
      communicator_(communicator),
      result_path_(directory / (ready.scene.name + ".h5")),
      checkpoint_directory_(directory / (ready.scene.name + "_checkpoints")),
      identity_{IDIOPHONE_VERSION, ready.mesh_hash, ready.scene.deck_text, ready.scene.overrides},
      motion_(ready.scene, ready.part, ready.attachments, ready.partners, ready.step(), ready.steps_per_sample,
              communicator),
      surface_(ready.part.surface, source::vertex_positions(ready.part), sampling(ready)),
      audio_path_(ready.scene, source::audible_surface(ready), -surface_.sampling().latency(), stages_, communicator),
      observer_(ready, communicator),
      node_rows_(owned_node_ids(ready.part), ready.part.global_nodes, communicator),
      triangle_rows_(ready.part.triangle_ids, ready.part.global_triangles, communicator),
      vertex_rows_(ready.part.vertex_ids, ready.part.global_vertices, communicator),
      sound_samples_(std::max<std::int64_t>(1, std::llround(ready.scene.time.duration * ready.scene.audio.rate))),
      last_sample_(audio_path_.completing_sample(sound_samples_) + surface_.sampling().latency()) {
  MPI_Comm_rank(communicator_, &rank_);
  MPI_Comm_size(communicator_, &ranks_);
  if (ready.scene.output.surface_motion) {
    recorder_.emplace(ready, triangle_rows_, vertex_rows_, -surface_.sampling().latency(), sound_samples_,
                      record::recording_of(result_path_), communicator_);
  }
  if (!resume) {
    begin();
    return;
  }
  auto search = store::find_checkpoint(checkpoint_directory_, identity_, communicator_);
  for (const auto& [path, reason] : search.refused) {
    if (rank_ == 0) {
      spdlog::warn("checkpoint {} refused: {}", path.string(), reason);
    }
  }
  if (search.checkpoint) {
    resume_from(*search.checkpoint);
  } else if (search.refused.empty()) {
    if (rank_ == 0) {
      spdlog::info("no checkpoint in {}: starting from the beginning", checkpoint_directory_.string());
    }
    begin();
  } else {
    throw std::runtime_error(fmt::format(
        "none of the checkpoints in {} can be resumed from; to start again from the beginning, leave --resume out",
        checkpoint_directory_.string()));
  }
}

void Simulation::begin() {
  result_ = store::ResultFile::create(
      result_path_, {ready_.scene.name, IDIOPHONE_VERSION, ready_.scene.deck_text, ready_.scene.overrides},
      communicator_);
  audio_path_.declare(*result_);
  observer_.declare(*result_);
  motion_.start(ready_.outset.centres, ready_.outset.displacement);
  report_overlaps();
  report_silence();
  read_surface();
  const surface::SurfaceMotion steady = surface_.start(surface_velocities());
  audio_path_.start(steady);
  if (recorder_) {
    recorder_->create();
    recorder_->note(steady);
  }
  observer_.note(0, motion_);
  const source::Observation seen = source::observe(ready_, motion_, communicator_);
  energy_at_start_ = seen.energy();
  largest_given_ = energy_at_start_ - seen.gravitational;
}

int Simulation::run(bool progress_line) {
  Progress progress({last_sample_, ready_.scene.audio.rate, ready_.steps_per_sample, "steps"}, sample_, progress_line,
                    rank_ == 0);
  const std::int64_t begun_at = sample_;
  started_ = last_checkpoint_ = MPI_Wtime();
  Verdict verdict{first_block, 0, 0};
  while (sample_ < last_sample_ && verdict.stop == 0) {
    const double block_start = MPI_Wtime();
    const std::int64_t block = std::min(verdict.next_block, last_sample_ - sample_);
    MPI_Pcontrol(1);  // inside a block nobody waits for all: no collective calls
    for (std::int64_t i = 0; i < block; ++i) {
      advance_sample();
    }
    MPI_Pcontrol(0);
    finish_block();
    verdict = agree(MPI_Wtime() - block_start, block);
    if (verdict.checkpoint != 0) {
      write_checkpoint();
    }
    progress.tell(sample_, fmt::format("loudest {:.3g}  checkpoints {}", audio_path_.loudest(), checkpoints_));
  }
  report_penetrations();
  const double elements =
      static_cast<double>(sample_ - begun_at) * ready_.steps_per_sample * ready_.part.global_elements;
  progress.conclude(fmt::format("{:.4g} million elements a second and core, everything included",
                                elements / progress.elapsed() / ranks_ / 1e6),
                    stages_);
  return verdict.stop != 0 ? exit_resumable : exit_finished;
}

void Simulation::advance_sample() {
  for (int read = 0; read < surface_.sampling().reads_per_sample(); ++read) {
    {
      const parallel::Stages::Scope stage(stages_, parallel::Stage::motion);
      for (int step = 0; step < ready_.steps_per_read; ++step) {
        motion_.advance();
      }
    }
    const parallel::Stages::Scope stage(stages_, parallel::Stage::surface);
    read_surface();
    surface_.read();
  }
  stages_.move(parallel::Stage::motion, parallel::Stage::contact, motion_.contacts().take_seconds());
  ++sample_;
  {
    const parallel::Stages::Scope stage(stages_, parallel::Stage::surface);
    surface_.take(surface_motion_);
  }
  if (recorder_) {
    const parallel::Stages::Scope stage(stages_, parallel::Stage::store);
    recorder_->note(surface_motion_);
  }
  audio_path_.hear(surface_motion_);
  if (sample_ <= sound_samples_) {  // what comes after only completes the sound
    observer_.note(sample_, motion_);
  }
}

void Simulation::read_surface() {
  const std::span<double> displacements = surface_.displacements();
  for (std::size_t v = 0; v < ready_.part.vertices.size(); ++v) {
    const auto& u = motion_.state()[static_cast<std::size_t>(ready_.part.vertices[v])].displacement;
    std::copy_n(u, 3, displacements.begin() + static_cast<std::ptrdiff_t>(3 * v));
  }
}

std::vector<double> Simulation::surface_velocities() const {
  std::vector<double> velocities;
  for (const Index vertex : ready_.part.vertices) {
    const auto& v = motion_.state()[static_cast<std::size_t>(vertex)].velocity;
    velocities.insert(velocities.end(), v, v + 3);
  }
  return velocities;
}

void Simulation::finish_block() {
  const parallel::Stages::Scope stage(stages_, parallel::Stage::store);
  require_stability();
  if (recorder_) {
    recorder_->write();
  }
  audio_path_.write(*result_, sound_samples_);
  observer_.write(*result_);
  result_->flush();
}

Simulation::Verdict Simulation::agree(double block_seconds, std::int64_t block) {
  int signal = noted_signal();
  MPI_Allreduce(MPI_IN_PLACE, &signal, 1, MPI_INT, MPI_MAX, communicator_);
  Verdict verdict;
  if (rank_ == 0) {
    const double now = MPI_Wtime();
    const std::int64_t longest = recorder_ ? std::min(recorder_->most_samples(), longest_block) : longest_block;
    verdict.next_block = next_block(block, block_seconds, longest);
    const auto& limit = ready_.scene.time.wall_clock_limit;
    const bool out_of_time = limit && now - started_ > *limit;
    verdict.stop = sample_ < last_sample_ && (signal != 0 || out_of_time) ? 1 : 0;
    const double interval = 60 * ready_.scene.output.checkpoint_minutes;
    verdict.checkpoint = verdict.stop != 0 || (interval > 0 && now - last_checkpoint_ > interval) ? 1 : 0;
    if (verdict.stop != 0) {
      spdlog::info("stopping in good order: {}", signal != 0 ? fmt::format("signal {}", signal) : "wall-clock limit");
    }
  }
  MPI_Bcast(&verdict, sizeof(verdict), MPI_BYTE, 0, communicator_);
  return verdict;
}

}  // namespace idiophone::app
