// `idiophone proxies`: `play` with the bodies of a deck as mass-spring proxies, also by the deck's radiation model.

#include <stdexcept>
#include <utility>

#include "command.hpp"
#include "idiophone/instruments/proxy_bodies/proxy_bodies.hpp"
#include "idiophone/run/loop/stop.hpp"
#include "idiophone/timbre/playing/playing.hpp"
#include "proxies_radiated.hpp"
#include "stage_options.hpp"

namespace idiophone::app {

namespace {

struct ProxiesOptions {
  timbre::PlaySettings settings;  ///< with one deck
  std::filesystem::path folder;   ///< for a result by the radiation model of the deck, if any
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
  if (settings.osc) {
    throw std::runtime_error("--output-folder writes what a score or a result says; leave out --osc");
  }
}

/// By the radiation model of the deck.
int write_result(const ProxiesOptions& options) {
  timbre::DrivenProxies driven = timbre::driven_proxies(options.settings);
  proxy_bodies::warn_of_what_proxies_lack(driven.scene);
  std::vector<proxy_bodies::ProxyBody> bodies;
  for (std::size_t body = 0; body < driven.scene.bodies.size(); ++body) {
    bodies.push_back({driven.scene.bodies[body].name, driven.levels[body].front()});
  }
  const proxies::EngineOptions& engine = options.settings.proxies.engine;
  return radiate_proxies(std::move(driven.scene), driven.score, bodies, std::move(driven.forces),
                         {.integrator = engine.integrator, .significant_distance = engine.significant_distance},
                         options.folder);
}

int proxies(const ProxiesOptions& options) {
  check_proxies(options);
  if (!options.folder.empty()) {
    return write_result(options);
  }
  timbre::play(options.settings);
  return loop::exit_finished;
}

}  // namespace

Command proxies_command() {
  return make_command<ProxiesOptions>("proxies", "render bodies as mass-spring proxies with levels of detail",
                                      Ranks::one, declare, proxies);
}

}  // namespace idiophone::app
