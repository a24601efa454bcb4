// `idiophone play`: plays sound maps, proxies and timbre trees.

#include "command.hpp"
#include "idiophone/run/loop/stop.hpp"
#include "idiophone/timbre/playing/playing.hpp"
#include "stage_options.hpp"

namespace idiophone::app {

namespace {

struct PlayOptions {
  timbre::PlaySettings settings;
  Style style = Style::text;
};

void declare(CLI::App& app, PlayOptions& options) {
  timbre::PlaySettings& settings = options.settings;
  settings.rate = 48000;
  app.add_option("files", settings.files, "sound maps (.h5), decks of proxies (.yaml) and timbre trees (.tt)")
      ->required();
  add_overrides(app, settings.score_overrides);
  app.add_option("--set-deck", settings.deck_overrides, "KEY.PATH=VALUE: overrides a value of the decks")
      ->take_all()
      ->expected(1);
  add_stage(app, settings);
  app.add_option("--rate", settings.rate, "audio samples per second")
      ->check(CLI::Range(8000, 192000))
      ->capture_default_str();
  app.add_option("--frames", settings.frames, "audio samples that the device asks for at once")
      ->check(CLI::Range(16, 8192))
      ->capture_default_str();
  add_proxies(app, settings.proxies);
  app.add_flag("!--no-masking", settings.masking,
               "a budget leaves out the weakest modes of a sound map first, not those that others hide");
  app.add_option("--detail-report", settings.detail_report,
                 "CSV file for what a budget leaves of the sound maps over time");
  add_json(app, options.style);
}

int play(const PlayOptions& options) {
  const timbre::Performance done = timbre::play(options.settings);
  if (options.style == Style::json) {
    print_facts(options.settings, done);
  }
  return loop::exit_finished;
}

}  // namespace

Command play_command() {
  return make_command<PlayOptions>("play",
                                   "play sound maps, proxies and timbre trees in real time, or write their sound",
                                   Ranks::one, declare, play);
}

}  // namespace idiophone::app
