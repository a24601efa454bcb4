// `idiophone run`: from a deck to sound.

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <utility>

#include "command.hpp"
#include "idiophone/foundation/parallel/errors.hpp"
#include "idiophone/foundation/version.hpp"
#include "idiophone/run/bodies/combined_source.hpp"
#include "idiophone/run/bodies/finite_element_source.hpp"
#include "idiophone/run/bodies/read_run_deck.hpp"
#include "idiophone/run/bodies/recorded_source.hpp"
#include "idiophone/run/loop/checkpoint_schedule.hpp"
#include "idiophone/run/loop/facts.hpp"
#include "idiophone/run/loop/output_lock.hpp"
#include "idiophone/run/loop/progress.hpp"
#include "idiophone/run/loop/run_loop.hpp"
#include "idiophone/run/loop/stop.hpp"
#include "idiophone/run/loop/wav_files.hpp"
#include "idiophone/run/record/channel_recorder.hpp"
#include "idiophone/run/record/frame_recorder.hpp"
#include "idiophone/run/record/surface_recorder.hpp"
#include "idiophone/run/results/checkpoint_archive.hpp"
#include "idiophone/timbre/track/sonic_sounds.hpp"

namespace idiophone::app {

namespace {

struct RunOptions {
  std::filesystem::path deck;
  std::vector<std::string> overrides;
  std::filesystem::path output = "results";
  bool resume = false;
  std::filesystem::path scene;  ///< a sonic scene whose sounds are made, too; empty for none
  loop::ProgressWish progress = loop::ProgressWish::automatic;
};

void declare(CLI::App& app, RunOptions& options) {
  add_deck(app, options.deck, options.overrides);
  add_output_folder(app, options.output, "folder of the results");
  add_progress(app, options.progress);
  app.add_option(
      "--scene", options.scene,
      "a sonic scene, whose sounds are bound to the motion and become part of the result (docs/use/timbre.md)");
  app.add_flag("--resume", options.resume, "go on from the newest checkpoint in the output folder");
}

/// Names listeners that hear nothing.
void report_silence(const scene::Scene& scene) {
  for (const auto& obstacle : scene.obstacles) {
    const radiation::HalfSpace space{obstacle.at, obstacle.direction};
    for (const auto& listener : scene.listeners) {
      for (const auto& receiver : listener.receivers) {
        if (scene.radiation.visibility && obstacle.shape == scene::Obstacle::Shape::half_space &&
            space.contains(receiver.position)) {
          spdlog::warn("listener {}: it is inside the obstacle {} and hears nothing", receiver.channel, obstacle.name);
        }
      }
    }
  }
}

[[nodiscard]] record::Recorders make_recorders(const bodies::Preparation& ready, bodies::FiniteElementSource& bodies,
                                               const bodies::Source& source, bodies::Channels& channels,
                                               results::ResultFile& result, const std::filesystem::path& result_path,
                                               MPI_Comm communicator) {
  const scene::Scene& scene = ready.scene;
  record::Recorders recorders;
  recorders.push_back(std::make_unique<record::ChannelRecorder>(channels, result));
  if (scene.output.frames_per_second > 0) {
    recorders.push_back(std::make_unique<record::FrameRecorder>(ready, bodies, result, communicator));
  }
  if (scene.output.surface_motion) {
    recorders.push_back(std::make_unique<record::SurfaceRecorder>(scene, source.surface(), source.first_sample(),
                                                                  bodies::sound_samples(scene),
                                                                  record::recording_of(result_path), communicator));
  }
  return recorders;
}

/// @throws std::runtime_error with advice when a file of the run is not what the checkpoint needs
template <class Restore>
auto with_advice(const Restore& restore) {
  try {
    return restore();
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(
        fmt::format("{}; resuming goes on with this file, so bring it back, or, to start again from the beginning, "
                    "leave --resume out",
                    error.what()));
  }
}

/// The result file of a run that starts at the beginning. Collective.
results::ResultFile create_result(const bodies::Preparation& ready, const std::filesystem::path& path,
                                  MPI_Comm communicator) {
  const scene::Scene& scene = ready.scene;
  auto result =
      results::ResultFile::create(path, {scene.name, program_version, scene.deck_text, scene.overrides}, communicator);
  result.note("/run", loop::run_facts(ready, communicator));
  return result;
}

/// What a resumed run continues.
std::vector<results::ContinuedFile> continued_files(const scene::Scene& scene, const std::filesystem::path& result) {
  std::vector<results::ContinuedFile> files = {{result, results::ResultFile::archive_prefix}};
  if (scene.output.surface_motion) {
    files.push_back({record::recording_of(result), results::SurfaceMotionFile::archive_prefix});
  }
  return files;
}

void restore(const results::CheckpointReader& checkpoint, const scene::Scene& scene, loop::RunLoop& loop,
             MPI_Comm communicator) {
  results::RestoringArchive archive(checkpoint, communicator);
  with_advice([&] { loop.archive(archive); });
  if (parallel::is_root(communicator)) {
    spdlog::info("resuming from {} at {:.6g} s", checkpoint.path().string(),
                 static_cast<double>(checkpoint.moment().sample) / scene.audio.rate);
  }
}

/// The computed bodies, and all bodies of the scene.
struct BodySources {
  std::unique_ptr<bodies::Source> all;
  bodies::FiniteElementSource* computed = nullptr;
};

/// Collective.
BodySources make_sources(const bodies::Preparation& ready, parallel::Stages& stages, MPI_Comm communicator) {
  auto bodies = std::make_unique<bodies::FiniteElementSource>(ready, stages, communicator);
  BodySources made{nullptr, bodies.get()};
  if (ready.scene.recorded_bodies.empty()) {
    made.all = std::move(bodies);
    return made;
  }
  std::vector<std::unique_ptr<bodies::Source>> sources;
  sources.push_back(std::move(bodies));
  for (const scene::RecordedBody& body : ready.scene.recorded_bodies) {
    std::optional<results::SurfaceMotionReader> reader;
    parallel::collectively(communicator, [&] { reader.emplace(body.recording); });
    sources.push_back(std::make_unique<bodies::RecordedSource>(body.name, std::move(*reader), ready.scene.radiation,
                                                               bodies::RecordedObstacles::leave_out, communicator));
  }
  made.all = std::make_unique<bodies::CombinedSource>(std::move(sources));
  return made;
}

/// What a checkpoint must have in common with this run. Collective.
results::Identity identity(const bodies::Preparation& ready, const std::optional<timbre::SceneOfRun>& sonic_scene,
                           MPI_Comm communicator) {
  std::string recordings, text = ready.scene.deck_text;
  parallel::on_root(communicator, [&] {
    recordings = bodies::fingerprint(ready.scene);
    text += sonic_scene ? sonic_scene->text() : "";
  });
  return {program_version, ready.mesh_hash + recordings, text, ready.scene.overrides};
}

/// @return the exit status
int simulate(const bodies::Preparation& ready, const RunOptions& options,
             const std::optional<timbre::SceneOfRun>& sonic_scene, MPI_Comm communicator) {
  const scene::Scene& scene = ready.scene;
  const std::filesystem::path result_path = options.output / (scene.name + ".h5");
  parallel::Stages stages;
  const BodySources sources = make_sources(ready, stages, communicator);
  bodies::Source& source = *sources.all;
  propagation::AudioPath audio_path(scene, source.surface(), source.first_sample(), stages, communicator);
  if (propagation::AirLoad* const air = audio_path.load()) {
    sources.computed->couple(*air);
  }

  loop::CheckpointSchedule checkpoints(options.output / (scene.name + "_checkpoints"),
                                       identity(ready, sonic_scene, communicator), scene.output, communicator);
  const auto checkpoint = options.resume ? checkpoints.find(continued_files(scene, result_path)) : std::nullopt;
  loop::watch_signals(loop::OnSignal::note);  // from here on there is something to lose
  results::ResultFile result = checkpoint
                                   ? with_advice([&] { return results::ResultFile::open(result_path, communicator); })
                                   : create_result(ready, result_path, communicator);
  bodies::Channels channels(source.channels());
  record::Recorders recorders =
      make_recorders(ready, *sources.computed, source, channels, result, result_path, communicator);

  const std::int64_t samples = bodies::sound_samples(scene);
  const loop::RunLoop::Extent extent{samples, audio_path.completing_sample(samples) - source.first_sample(),
                                     ready.steps_per_sample, ready.part.global_nodes};
  loop::RunLoop loop({source, audio_path, recorders, result, stages}, extent, communicator);
  if (checkpoint) {
    restore(*checkpoint, scene, loop, communicator);
  } else {
    loop.start();
    if (sonic_scene) {
      sonic_scene->declare(result, result_path);
    }
  }
  const std::int64_t begun_at = loop.advanced();
  const int rank = parallel::rank_of(communicator);
  nlohmann::json facts = loop::job_facts(begun_at, parallel::size_of(communicator));
  facts["largest_part"] = loop::part_facts(loop::largest_part(ready.part, communicator));
  const std::string job = result.add_job(facts);
  loop::Progress progress({extent.samples, scene.audio.rate, ready.steps_per_sample, "steps"}, begun_at,
                          loop::progress_style(options.progress, rank));
  const bool finished = loop.run(scene.time.wall_clock_limit, &checkpoints, progress);
  source.report();
  const double elements =
      static_cast<double>(loop.advanced() - begun_at) * ready.steps_per_sample * ready.part.global_elements;
  result.note(job, loop::end_facts({loop.advanced(), elements, progress.elapsed(), progress.processor_time(),
                                    loop::memory_peaks(communicator)},
                                   stages));
  result.flush();
  progress.conclude(fmt::format("{:.4g} million elements a second and core, everything included",
                                elements / progress.elapsed() / parallel::size_of(communicator) / 1e6),
                    stages);
  if (finished && sonic_scene) {
    sonic_scene->render(result, result_path, options.progress);
  }
  return finished ? loop::exit_finished : loop::exit_resumable;
}

int run(const RunOptions& options) {
  MPI_Comm communicator = MPI_COMM_WORLD;
  scene::Scene scene = bodies::read_deck(options.deck, options.overrides, communicator);
  std::optional<timbre::SceneOfRun> sonic_scene;
  if (!options.scene.empty()) {
    sonic_scene.emplace(options.scene, communicator);
  }
  const loop::OutputLock lock(options.output, scene.name, communicator);
  const bodies::Preparation ready = bodies::prepare(std::move(scene), communicator);
  parallel::on_root(communicator, [&] { report_silence(ready.scene); });
  const int status = simulate(ready, options, sonic_scene, communicator);
  if (status == loop::exit_finished) {
    loop::watch_signals(loop::OnSignal::end_wavs);  // the result is complete but for its WAV files
    parallel::on_root(communicator, [&] { loop::write_wavs(ready.scene, options.output); });
  }
  return status;
}

}  // namespace

Command run_command() {
  return make_command<RunOptions>("run", "compute the sound of a deck", Ranks::any, declare, run);
}

}  // namespace idiophone::app
