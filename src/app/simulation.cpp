#include "simulation.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "idiophone/surface/sampling.hpp"
#include "stop.hpp"

namespace idiophone::app {

namespace {

surface::Sampling sampling(const Preparation& ready) {
  const auto& audio = ready.scene.audio;
  return {audio.rate,          ready.steps_per_sample,   ready.steps_per_read,
          audio.max_frequency, audio.kernel_wavelengths, ready.scene.radiation.air.impedance()};
}

surface::SurfacePressure surface_pressure(const Preparation& ready) {
  using Field = surface::SurfacePressure::Field;
  const auto& radiation = ready.scene.radiation;
  if (!radiation.asks_for_radii()) {
    return {};
  }
  const bool pulsating = radiation.surface_pressure == scene::SurfacePressure::pulsating;
  return {pulsating ? Field::pulsating : Field::oscillating, ready.radii, radiation.air.speed / ready.scene.audio.rate};
}

std::vector<Vector3> vertex_positions(const mesh::Part& part) {
  std::vector<Vector3> positions;
  for (const Index node : part.vertices) {
    positions.push_back(part.reference[static_cast<std::size_t>(node)]);
  }
  return positions;
}

std::vector<Index> owned_node_ids(const mesh::Part& part) {
  return {part.node_ids.begin(), part.node_ids.begin() + part.owned_nodes};
}

}  // namespace

Simulation::Simulation(const Preparation& ready, const std::filesystem::path& directory, bool resume,
                       MPI_Comm communicator)
    : ready_(ready),
      communicator_(communicator),
      result_path_(directory / (ready.scene.name + ".h5")),
      checkpoint_directory_(directory / (ready.scene.name + "_checkpoints")),
      identity_{IDIOPHONE_VERSION, ready.mesh_hash, ready.scene.deck_text, ready.scene.overrides},
      motion_(ready.scene, ready.part, ready.attachments, ready.partners, ready.step(), ready.steps_per_sample,
              communicator),
      surface_(ready.part.surface, vertex_positions(ready.part), sampling(ready)),
      emitter_(ready.part.surface, ready.scene.audio.dc_loss, surface_pressure(ready)),
      ears_(ready.scene, 1 - surface_.sampling().latency(), ready.part.surface.size()),
      observer_(ready, communicator),
      node_rows_(owned_node_ids(ready.part), ready.part.global_nodes, communicator),
      triangle_rows_(ready.part.triangle_ids, ready.part.global_triangles, communicator),
      vertex_rows_(ready.part.vertex_ids, ready.part.global_vertices, communicator) {
  MPI_Comm_rank(communicator_, &rank_);
  MPI_Comm_size(communicator_, &ranks_);
  const auto sound_samples = std::llround(ready.scene.time.duration * ready.scene.audio.rate);
  last_sample_ = std::max<std::int64_t>(1, sound_samples) + surface_.sampling().latency() + ears_.lookahead();
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
  for (const auto& listener : ready_.scene.listeners) {
    store::Series series{"/audio/" + listener.name,
                         std::string(ears_.model().unit()),
                         static_cast<double>(ready_.scene.audio.rate),
                         {},
                         std::string(ears_.model().description()),
                         {}};
    for (const auto& receiver : listener.receivers) {
      series.columns.push_back(receiver.channel);
      series.positions.push_back({receiver.position[0], receiver.position[1], receiver.position[2]});
    }
    result_->declare(series);
  }
  for (const auto& reference : ready_.scene.references) {
    result_->add_reference(reference.name, reference.frequencies);
  }
  observer_.declare(*result_);
  motion_.start(ready_.outset.centres, ready_.outset.displacement);
  report_overlaps();
  read_surface();
  emitter_.start(surface_.start(surface_velocities()));
  observer_.note(0, motion_);
  const Observation seen = observe(ready_, motion_, communicator_);
  energy_at_start_ = seen.energy();
  largest_given_ = energy_at_start_ - seen.gravitational;
}

int Simulation::run(bool progress_line) {
  Progress progress(ready_, last_sample_, sample_, progress_line, rank_ == 0);
  started_ = last_checkpoint_ = MPI_Wtime();
  Verdict verdict{16, 0, 0};
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
    progress.tell(sample_, loudest_, checkpoints_);
  }
  report_penetrations();
  progress.conclude(sample_, stages_, ranks_);
  return verdict.stop != 0 ? exit_resumable : exit_finished;
}

void Simulation::advance_sample() {
  for (int read = 0; read < surface_.sampling().reads_per_sample(); ++read) {
    {
      const Stages::Scope stage(stages_, Stage::motion);
      for (int step = 0; step < ready_.steps_per_read; ++step) {
        motion_.advance();
      }
    }
    const Stages::Scope stage(stages_, Stage::surface);
    read_surface();
    surface_.read();
  }
  stages_.move(Stage::motion, Stage::contact, motion_.contacts().take_seconds());
  ++sample_;
  {
    const Stages::Scope stage(stages_, Stage::surface);
    surface_.take(surface_motion_);
    emitter_.emit(surface_motion_, emission_);
  }
  try {
    const Stages::Scope stage(stages_, Stage::radiation);
    ears_.hear(emitted(), emission_);
  } catch (const std::runtime_error& error) {
    complaint_ = error.what();  // the others still wait for this rank's nodes: told at the end of the block
  }
  observer_.note(sample_, motion_);
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
  const Stages::Scope stage(stages_, Stage::store);
  require_stability();
  write_audio();
  observer_.write(*result_);
  result_->flush();
}

void Simulation::write_audio() {
  const std::int64_t final_samples = emitted() - ears_.lookahead();
  if (final_samples <= written_) {
    return;
  }
  const std::vector<std::vector<double>> sounds =
      ears_.take(static_cast<std::size_t>(final_samples - written_), communicator_);
  written_ = final_samples;
  for (std::size_t l = 0; l < sounds.size(); ++l) {
    result_->append("/audio/" + ready_.scene.listeners[l].name, sounds[l]);
    for (const double value : sounds[l]) {
      loudest_ = std::max(loudest_, std::abs(value));
    }
  }
}

Simulation::Verdict Simulation::agree(double block_seconds, std::int64_t block) {
  constexpr double wanted_seconds = 2.0;  // of a block: soon enough to stop, long enough to hide the writing
  int signal = noted_signal();
  MPI_Allreduce(MPI_IN_PLACE, &signal, 1, MPI_INT, MPI_MAX, communicator_);
  Verdict verdict;
  if (rank_ == 0) {
    const double now = MPI_Wtime();
    const double factor = std::clamp(wanted_seconds / std::max(block_seconds, 1e-6), 0.25, 4.0);
    verdict.next_block = std::clamp<std::int64_t>(std::llround(static_cast<double>(block) * factor), 1, 8192);
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
