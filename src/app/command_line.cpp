#include "command_line.hpp"

#include <algorithm>
#include <array>
#include <functional>

#include "idiophone/foundation/version.hpp"

namespace idiophone::app {

CommandLine::CommandLine() {
  app.set_version_flag("--version", program_version);
  app.require_subcommand(1);
  add_run_options();
  add_check_options();
  add_listen_options();
  add_modes_options();
  add_map_options();
  add_export_options();
  add_play_options();
  add_timbre_options();
  add_evolve_options();
  add_proxies_options();
  add_radiate_options();
  add_identify_options();
  add_tune_options();
  add_report_options();
}

bool CommandLine::answers_scripts() const {
  return check_options.resolved || check_options.style == Style::json || modes_options.style == Style::json ||
         radiate_options.style == Style::json || analyze_options.style == Style::json ||
         identify_options.style == Style::json || tune_options.style == Style::json;
}

int CommandLine::call() const {
  struct Command {
    const CLI::App* name;
    std::function<int()> call;
  };
  const std::array commands = {
      Command{run, [this] { return app::run(run_options); }},
      Command{check, [this] { return app::check(check_options); }},
      Command{modes, [this] { return app::modes(modes_options); }},
      Command{map, [this] { return app::map(map_options); }},
      Command{to_export, [this] { return app::export_map(export_options); }},
      Command{explore, [this] { return app::explore(explore_options); }},
      Command{report, [this] { return app::report(report_options); }},
      Command{radiate, [this] { return app::radiate(radiate_options); }},
      Command{identify, [this] { return app::identify(identify_options); }},
      Command{tune, [this] { return app::tune(tune_options); }},
      Command{listen, [this] { return app::listen(listen_options); }},
      Command{play, [this] { return app::play(play_options); }},
      Command{timbre, [this] { return app::timbre(timbre_options); }},
      Command{evolve, [this] { return app::evolve(evolve_options); }},
      Command{proxies, [this] { return app::proxies(proxies_options); }},
      Command{info, [this] { return app::info(info_options); }},
      Command{analyze, [this] { return app::analyze(analyze_options); }},
  };
  return std::ranges::find_if(commands, &CLI::App::parsed, &Command::name)->call();
}

}  // namespace idiophone::app
