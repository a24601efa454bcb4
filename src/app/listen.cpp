// `idiophone listen`: the sound of a recorded motion, at other listeners or by another model.

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "accelerator_choice.hpp"
#include "command.hpp"
#include "idiophone/air/propagation/ears.hpp"
#include "idiophone/foundation/parallel/errors.hpp"
#include "idiophone/foundation/version.hpp"
#include "idiophone/run/bodies/recorded_source.hpp"
#include "idiophone/run/loop/facts.hpp"
#include "idiophone/run/loop/job.hpp"
#include "idiophone/run/loop/output_lock.hpp"
#include "idiophone/run/loop/progress.hpp"
#include "idiophone/run/loop/stop.hpp"
#include "idiophone/run/record/surface_recorder.hpp"
#include "idiophone/run/results/surface_motion_reader.hpp"
#include "idiophone/run/results/verification.hpp"
#include "idiophone/scene/listening.hpp"
#include "listener_warnings.hpp"
#include "other_file.hpp"

namespace idiophone::app {

namespace {

struct ListenOptions {
  std::filesystem::path recording;  ///< NAME.h5, with NAME_surface.h5 beside it, or a recording
  std::filesystem::path deck;       ///< for listening; empty for the recorded one
  std::vector<std::string> overrides;
  std::filesystem::path output = "results";
  loop::ProgressWish progress = loop::ProgressWish::automatic;
  std::string accelerator;  ///< empty for none
};

void declare(CLI::App& app, ListenOptions& options) {
  app.add_option("recording", options.recording,
                 "NAME.h5 of a run with output: {surface_motion: true}, or a recording (docs/use/surface_motion.md)")
      ->required();
  app.add_option("deck", options.deck, "other listeners, a YAML file (default: the run's own deck)");
  add_overrides(app, options.overrides);
  add_output_folder(app, options.output, "folder of the results");
  add_progress(app, options.progress);
  add_accelerator(app, options.accelerator, "computes waves on a grid");
}

/// The recording beside a result, or the recording itself.
results::SurfaceMotionReader open_recording(const std::filesystem::path& file) {
  const auto beside = record::recording_of(file);
  if (!std::filesystem::exists(file) || !std::filesystem::exists(beside)) {
    try {
      return results::SurfaceMotionReader(file);
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(
          fmt::format("{}; there is no {} either: runs write it if their deck says output: {{surface_motion: true}}",
                      error.what(), beside.string()));
    }
  }
  return results::SurfaceMotionReader(beside);
}

scene::RecordedDeck recorded_deck(const ListenOptions& options, const surface::RecordingHeader& header) {
  return {options.recording,
          header.origin.name,
          header.origin.deck_text,
          header.origin.overrides,
          static_cast<int>(header.rate),
          {header.air_density, header.air_speed}};
}

void require_new_file(const std::filesystem::path& result, const std::filesystem::path& recording) {
  for (const auto& mine : {recording, record::recording_of(recording)}) {
    for (const auto& made : {result, record::recording_of(result)}) {
      require_other_file(made, mine);
    }
  }
}

void require_sound(const results::SurfaceMotionReader& reader, const std::filesystem::path& path) {
  if (reader.rows() - 1 + reader.header().first_sample < 1 || reader.header().samples < 1) {
    throw std::runtime_error(fmt::format("{}: {} audio samples from {} on hold no sound yet", path.string(),
                                         reader.rows(), reader.header().first_sample));
  }
}

void report(const scene::Scene& scene, const results::SurfaceMotionReader& reader) {
  const auto& header = reader.header();
  spdlog::info("recording of '{}': {} triangles, {:.6g} s at {} Hz", header.origin.name, reader.triangles(),
               static_cast<double>(reader.rows() - 1) / header.rate, header.rate);
  if (header.origin.code_version != program_version && !header.origin.code_version.empty()) {
    spdlog::info("  recorded by version {}; this is {}", header.origin.code_version, program_version);
  }
  if (reader.rows() - 1 + header.first_sample < header.samples) {
    spdlog::warn("  it ends before the sound does: {} of {} audio samples", reader.rows() - 1 + header.first_sample,
                 header.samples);
  }
  for (const auto& listener : scene.listeners) {
    for (const auto& receiver : listener.receivers) {
      spdlog::info("  {} at ({:.4g}, {:.4g}, {:.4g}) m", receiver.channel, receiver.position[0], receiver.position[1],
                   receiver.position[2]);
    }
  }
}

/// What is heard, on rank 0. Collective.
nlohmann::json facts_of(const bodies::RecordedSource& source, const ListenOptions& options, MPI_Comm communicator) {
  nlohmann::json facts;
  parallel::on_root(communicator, [&] {
    const std::string deck =
        scene::resolved_listening(recorded_deck(options, source.header()), options.deck, options.overrides);
    facts = loop::listening_facts(source.header(), source.surface(), deck);
  });
  return facts;
}

int listen(const ListenOptions& options) {
  MPI_Comm communicator = MPI_COMM_WORLD;
  // Rank 0 answers for file and deck; the others read them only once they are known to be right.
  std::optional<results::SurfaceMotionReader> reader;
  scene::Scene scene;
  const auto read = [&] {
    reader = open_recording(options.recording);
    scene = scene::read_listening(recorded_deck(options, reader->header()), options.deck, options.overrides);
  };
  parallel::on_root(communicator, [&] {
    results::require_intact(open_recording(options.recording).path());
    read();
    propagation::check_heads(scene);
    require_sound(*reader, options.recording);
    require_new_file(options.output / (scene.name + ".h5"), options.recording);
    report(scene, *reader);
  });
  if (!reader) {
    read();
  }
  const auto accelerator = open_accelerator(options.accelerator, {.waves = has_waves(scene.radiation)}, communicator);
  const loop::OutputLock lock(options.output, scene.name, communicator);
  bodies::RecordedSource source("", std::move(*reader), scene.radiation, bodies::RecordedObstacles::keep, communicator);
  check_placement(scene, source.surface(), communicator);
  parallel::Stages stages;
  const int status = loop::perform({.scene = scene,
                                    .source = source,
                                    .stages = stages,
                                    .folder = options.output,
                                    .sound_samples = source.header().samples,
                                    .facts = [&] { return facts_of(source, options, communicator); },
                                    .samples = source.samples(),
                                    .progress = loop::progress_style(options.progress, parallel::rank_of(communicator)),
                                    .accelerator = accelerator.get()},
                                   communicator)
                         .status;
  if (status == loop::exit_resumable && parallel::is_root(communicator)) {
    spdlog::info("the sound up to here is in the result; listening starts from the beginning next time");
  }
  return status;
}

}  // namespace

Command listen_command() {
  return make_command<ListenOptions>("listen", "hear a recorded motion with other listeners or another model",
                                     Ranks::any, declare, listen);
}

}  // namespace idiophone::app
