#include "idiophone/app/deck_run.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "accelerator_choice.hpp"
#include "idiophone/foundation/parallel/errors.hpp"
#include "idiophone/foundation/version.hpp"
#include "idiophone/run/bodies/combined_source.hpp"
#include "idiophone/run/bodies/finite_element_source.hpp"
#include "idiophone/run/bodies/read_run_deck.hpp"
#include "idiophone/run/bodies/recorded_source.hpp"
#include "idiophone/run/loop/facts.hpp"
#include "idiophone/run/loop/job.hpp"
#include "idiophone/run/loop/output_lock.hpp"
#include "idiophone/run/record/channel_recorder.hpp"
#include "idiophone/run/record/frame_recorder.hpp"
#include "idiophone/run/record/surface_recorder.hpp"
#include "idiophone/study/advice/run_warnings.hpp"
#include "idiophone/study/advice/sheet_places.hpp"
#include "idiophone/timbre/track/sonic_sounds.hpp"

namespace idiophone::app {

namespace {

/// What a resumed run continues.
std::vector<results::ContinuedFile> continued_files(const scene::Scene& scene, const std::filesystem::path& result) {
  std::vector<results::ContinuedFile> files = {{result, results::ResultFile::archive_prefix}};
  if (scene.output.surface_motion) {
    files.push_back({record::recording_of(result), results::SurfaceMotionFile::archive_prefix});
  }
  return files;
}

/// The computed bodies, and all bodies of the scene.
struct BodySources {
  std::unique_ptr<bodies::Source> all;
  bodies::FiniteElementSource* computed = nullptr;
};

/// Collective.
/// @param accelerator  of finite elements; null: the processor computes them
BodySources make_sources(const bodies::Preparation& ready, parallel::Stages& stages, MPI_Comm communicator,
                         accelerator::Accelerator* accelerator) {
  auto bodies = std::make_unique<bodies::FiniteElementSource>(ready, stages, communicator, accelerator);
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

/// Collective.
record::Recorders make_recorders(const bodies::Preparation& ready, const BodySources& sources,
                                 bodies::Channels& channels, results::ResultFile& result,
                                 const std::filesystem::path& result_path, MPI_Comm communicator) {
  const scene::Scene& scene = ready.scene;
  record::Recorders recorders;
  recorders.push_back(std::make_unique<record::ChannelRecorder>(channels, result));
  if (scene.output.frames_per_second > 0) {
    recorders.push_back(std::make_unique<record::FrameRecorder>(ready, *sources.computed, result, communicator));
  }
  if (scene.output.surface_motion) {
    recorders.push_back(std::make_unique<record::SurfaceRecorder>(
        scene, sources.all->surface(), sources.all->first_sample(), bodies::sound_samples(scene),
        record::recording_of(result_path), communicator));
  }
  return recorders;
}

/// The sounds of a sonic scene, which become part of the result when the motion is complete.
class SceneRecorder : public record::Recorder {
 public:
  /// @param scene, channels, result  must outlive this object
  SceneRecorder(timbre::SceneOfRun& scene, bodies::Channels& channels, results::ResultFile& result,
                std::filesystem::path path, loop::ProgressWish progress)
      : scene_(scene), channels_(channels), result_(result), path_(std::move(path)), progress_(progress) {}

  void declare() override { scene_.declare(result_); }
  void begin() override { scene_.bind(channels_, result_, path_); }
  void note(std::int64_t /*sample*/, const surface::SurfaceMotion& /*motion*/) override {}
  void write() override {}
  void finish() override { scene_.render(result_, path_, progress_); }
  void archive(parallel::Archive& /*archive*/) override {}

 private:
  timbre::SceneOfRun& scene_;
  bodies::Channels& channels_;
  results::ResultFile& result_;
  std::filesystem::path path_;
  loop::ProgressWish progress_;
};

/// What the accelerator of a run has to compute.
AcceleratedWork accelerated_work(const RunOptions& options, const scene::Scene& scene) {
  const bool has_elements =
      std::ranges::any_of(scene.bodies, [](const scene::Body& body) { return !body.modal.has_value(); });
  return {.waves = options.accelerated != Accelerated::elements && has_waves(scene.radiation),
          .elements = options.accelerated != Accelerated::waves && has_elements};
}

nlohmann::json largest_part_facts(const bodies::Preparation& ready, MPI_Comm communicator) {
  nlohmann::json facts;
  facts["largest_part"] = loop::part_facts(loop::largest_part(ready.part, communicator), motion::halo_of(ready.scene));
  return facts;
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

}  // namespace

int run_deck(const RunOptions& options, MPI_Comm communicator) {
  scene::Scene scene = bodies::read_deck(options.deck, options.overrides, communicator);
  std::optional<timbre::SceneOfRun> sonic_scene;
  if (!options.scene.empty()) {
    sonic_scene.emplace(options.scene, communicator);
  }
  const AcceleratedWork work = accelerated_work(options, scene);
  const auto accelerator = open_accelerator(options.accelerator, work, communicator);
  const loop::OutputLock lock(options.output, scene.name, communicator);
  const bodies::Preparation ready = bodies::prepare(std::move(scene), communicator);
  const std::vector<std::optional<std::string>> sheets = advice::sheet_warnings(ready, communicator);
  parallel::on_root(communicator, [&] {
    advice::report_doubts(ready);
    advice::print(sheets);
  });
  const std::filesystem::path result_path = options.output / (ready.scene.name + ".h5");
  parallel::Stages stages;
  const BodySources sources = make_sources(ready, stages, communicator, work.elements ? accelerator.get() : nullptr);
  bodies::Channels channels(sources.all->channels());
  const auto recorders = [&](results::ResultFile& result) {
    record::Recorders all = make_recorders(ready, sources, channels, result, result_path, communicator);
    if (sonic_scene) {
      all.push_back(std::make_unique<SceneRecorder>(*sonic_scene, channels, result, result_path, options.progress));
    }
    return all;
  };
  return loop::perform({.scene = ready.scene,
                        .source = *sources.all,
                        .stages = stages,
                        .folder = options.output,
                        .sound_samples = bodies::sound_samples(ready.scene),
                        .facts = [&] { return loop::run_facts(ready, communicator); },
                        .step = loop::StepSize{ready.steps_per_sample, ready.part.global_nodes,
                                               static_cast<double>(ready.part.global_elements)},
                        .wall_clock_limit = ready.scene.time.wall_clock_limit,
                        .checkpoints = loop::JobCheckpoints{identity(ready, sonic_scene, communicator),
                                                            continued_files(ready.scene, result_path), options.resume},
                        .progress = loop::progress_style(options.progress, parallel::rank_of(communicator)),
                        .accelerator = work.waves ? accelerator.get() : nullptr,
                        .job_facts = [&] { return largest_part_facts(ready, communicator); },
                        .recorders = recorders},
                       communicator)
      .status;
}

}  // namespace idiophone::app
