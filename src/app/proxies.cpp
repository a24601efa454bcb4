// `idiophone proxies`: `play` with the bodies of a deck as mass-spring proxies, also by the deck's radiation model.

#include <spdlog/spdlog.h>

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "answer.hpp"
#include "command.hpp"
#include "idiophone/instruments/proxy_bodies/proxy_bodies.hpp"
#include "idiophone/instruments/proxy_bodies/proxy_frames.hpp"
#include "idiophone/instruments/proxy_bodies/proxy_source.hpp"
#include "idiophone/instruments/score/score.hpp"
#include "idiophone/run/bodies/finite_element_source.hpp"
#include "idiophone/run/loop/job.hpp"
#include "idiophone/run/loop/output_lock.hpp"
#include "idiophone/run/loop/stop.hpp"
#include "idiophone/scene/resolved_deck.hpp"
#include "idiophone/timbre/playing/playing.hpp"
#include "listener_warnings.hpp"
#include "stage_options.hpp"

namespace idiophone::app {

namespace {

struct ProxiesOptions {
  timbre::PlaySettings settings;  ///< with one deck
  std::filesystem::path folder;   ///< for a result by the radiation model of the deck, if any
  Style style = Style::text;
};

void declare(CLI::App& app, ProxiesOptions& options) {
  timbre::PlaySettings& settings = options.settings;
  settings.frames = settings.buffer_frames;
  app.add_option("deck", settings.files, "the scene, a YAML file (docs/use/deck.md)")->required()->expected(1);
  add_overrides(app, settings.deck_overrides);
  app.add_option("--output-folder", options.folder,
                 "folder for NAME.h5 and its WAV files: the sound by the radiation model of the deck");
  add_renamed(app, "--result", "--output-folder");
  add_stage(app, settings);
  app.add_option_function<int>(
         "--frames", [&settings](int frames) { settings.frames = settings.buffer_frames = frames; },
         "audio samples in a buffer (default: 256)")
      ->check(CLI::Range(16, 8192));
  add_proxies(app, settings.proxies);
  add_json(app, options.style);
}

void check_proxies(const ProxiesOptions& options) {
  const timbre::PlaySettings& settings = options.settings;
  if (settings.score.empty() && settings.contacts.empty() && settings.midi.empty() && !settings.osc) {
    throw std::runtime_error("nothing drives the proxies; give --score, --contacts, --midi or --osc");
  }
  if (options.folder.empty()) {
    return;
  }
  if (!settings.output.empty() || settings.proxies.levels > 1 || settings.proxies.engine.largest_divisor > 1) {
    throw std::runtime_error(
        "--output-folder computes each body in full; leave out --output, --levels and --lowest-rate");
  }
  if (!settings.proxies.strength.empty()) {
    throw std::runtime_error("--output-folder can't break a body; leave out --strength, or use --output");
  }
  if (!settings.midi_out.empty()) {
    throw std::runtime_error("--output-folder writes sound; leave out --midi-out");
  }
  if (settings.osc) {
    throw std::runtime_error("--output-folder writes what a score or a result says; leave out --osc");
  }
}

nlohmann::json size_facts(const std::vector<proxy_bodies::ProxyBody>& bodies) {
  nlohmann::json facts;
  for (const proxy_bodies::ProxyBody& body : bodies) {
    facts[body.name] = {{"masses", body.lattice->masses().size()},
                        {"springs", body.lattice->springs().size()},
                        {"triangles", body.lattice->mesh().surface.size()}};
  }
  return facts;
}

void refuse_tunings(const score::Score& score) {
  for (const score::ScoreEvent& event : score.events) {
    if (std::holds_alternative<score::Tuning>(event.action) || std::holds_alternative<score::Detail>(event.action)) {
      throw std::runtime_error(
          "--output-folder can't tune a body; leave out the events of type tune and detail, or use --output");
    }
  }
}

void report_result(const ProxiesOptions& options, const scene::Scene& scene, const nlohmann::json& sizes,
                   const loop::JobEnding& ending) {
  const bool is_complete = ending.status == loop::exit_finished;
  if (is_complete) {
    spdlog::info("{:.4g} s of sound in {:.3g} s of processor time", scene.time.duration, ending.processor_time);
  } else {
    spdlog::info("the sound up to here is in the result");
  }
  if (options.style == Style::json) {
    const nlohmann::json answer = {{"output", (options.folder / (scene.name + ".h5")).string()},
                                   {"bodies", sizes},
                                   {"rate", scene.audio.rate},
                                   {"duration", scene.time.duration},
                                   {"processor_time", ending.processor_time},
                                   {"is_complete", is_complete}};
    print_answer(answer);
  }
}

record::Recorders make_recorders(const std::vector<proxy_bodies::ProxyBody>& bodies,
                                 const proxy_bodies::ProxySource& source, const scene::Scene& scene,
                                 results::ResultFile& result) {
  record::Recorders recorders;
  if (scene.output.frames_per_second > 0.0) {
    recorders.push_back(std::make_unique<proxy_bodies::ProxyFrames>(bodies, source, scene, result));
  }
  return recorders;
}

/// By the radiation model of the deck.
int write_result(const ProxiesOptions& options) {
  timbre::DrivenProxies driven = timbre::driven_proxies(options.settings);
  refuse_tunings(driven.score);
  scene::Scene scene = score::as_scored(std::move(driven.scene), driven.score);
  if (options.settings.proxies.frames_per_second > 0.0) {
    scene.output.frames_per_second = options.settings.proxies.frames_per_second;
  }
  proxy_bodies::warn_of_what_proxies_lack(scene);
  if (!scene.obstacles.empty()) {
    spdlog::warn("obstacles do not reflect or hide the sound of proxies");
  }
  std::vector<proxy_bodies::ProxyBody> sounding;
  for (std::size_t body = 0; body < scene.bodies.size(); ++body) {
    sounding.push_back({scene.bodies[body].name, driven.levels[body].front(), driven.tracks[body]});
  }
  const loop::OutputLock lock(options.folder, scene.name, MPI_COMM_WORLD);
  const proxies::EngineOptions& engine = options.settings.proxies.engine;
  proxy_bodies::ProxySource source(
      sounding, std::move(driven.forces), scene,
      {.integrator = engine.integrator, .significant_distance = engine.significant_distance});
  check_placement(scene, source.surface(), MPI_COMM_WORLD);
  const nlohmann::json sizes = size_facts(sounding);
  const nlohmann::json facts = {{"deck", scene::resolved_deck(scene.deck, scene.overrides)}, {"bodies", sizes}};
  parallel::Stages stages;
  const loop::JobEnding ending = loop::perform(
      {.scene = scene,
       .source = source,
       .stages = stages,
       .folder = options.folder,
       .sound_samples = bodies::sound_samples(scene),
       .facts = [&] { return facts; },
       .recorders = [&](results::ResultFile& result) { return make_recorders(sounding, source, scene, result); }},
      MPI_COMM_WORLD);
  report_result(options, scene, sizes, ending);
  return ending.status;
}

int proxies(const ProxiesOptions& options) {
  check_proxies(options);
  if (!options.folder.empty()) {
    return write_result(options);
  }
  const timbre::Performance done = timbre::play(options.settings);
  if (options.style == Style::json) {
    print_facts(options.settings, done);
  }
  return loop::exit_finished;
}

}  // namespace

Command proxies_command() {
  return make_command<ProxiesOptions>("proxies", "render bodies as mass-spring proxies with levels of detail",
                                      Ranks::one, declare, proxies);
}

}  // namespace idiophone::app
