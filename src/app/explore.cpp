// `idiophone explore`: the Sonic Explorer, a web page on which the bodies of sound maps are struck.

#include "command.hpp"
#include "idiophone/foundation/web/page_file.hpp"
#include "idiophone/instruments/explorer/explorer_page.hpp"
#include "idiophone/instruments/proxy_bodies/proxy_bodies.hpp"
#include "idiophone/instruments/sound_maps/sound_map_file.hpp"
#include "idiophone/instruments/voices/sound_map_voices.hpp"
#include "idiophone/run/bodies/read_run_deck.hpp"
#include "idiophone/run/loop/stop.hpp"
#include "idiophone/scene/find_body.hpp"
#include "map_warnings.hpp"
#include "stage_options.hpp"

namespace idiophone::app {

namespace {

struct ExploreOptions {
  std::vector<std::string> maps;                 ///< NAME_BODY.map.h5
  std::filesystem::path page = "explorer.html";  ///< to write
  std::filesystem::path proxies;                 ///< deck whose bodies also get proxies, if any
  std::vector<std::string> overrides;            ///< of this deck
  proxy_bodies::Springs springs = proxy_bodies::Springs::van_gelder;
  int levels = 1;  ///< meshes of each body, each with elements twice as large as the one before
};

void declare(CLI::App& app, ExploreOptions& options) {
  app.add_option("maps", options.maps,
                 "NAME_BODY.map.h5 ..., of one `map`; without maps the page makes its bodies itself");
  add_output_file(app, options.page, "the page to write");
  app.add_option("--proxies", options.proxies, "deck of the maps: its bodies also sound as proxies")->needs("maps");
  app.add_option("--levels", options.levels, "of detail of the proxies")
      ->check(CLI::Range(1, 6))
      ->capture_default_str();
  add_springs(app, options.springs);
  add_overrides(app, options.overrides);
  for (const char* of_proxies : {"--levels", "--springs", "--set"}) {
    app.get_option(of_proxies)->needs("--proxies");
  }
}

/// Of the bodies of the maps, or none.
std::vector<explorer::ProxyLevels> proxies_of_maps(const ExploreOptions& options,
                                                   const std::vector<sound_maps::SoundMap>& maps) {
  std::vector<explorer::ProxyLevels> proxies;
  if (!options.proxies.empty()) {
    const scene::Scene scene = bodies::read_deck(options.proxies, options.overrides, MPI_COMM_WORLD);
    for (const sound_maps::SoundMap& map : maps) {
      proxies.push_back(
          proxy_bodies::proxy_levels(scene, scene::find_body(scene.bodies, map.body), options.levels, options.springs));
    }
  }
  return proxies;
}

int explore(const ExploreOptions& options) {
  std::vector<sound_maps::SoundMap> maps;
  for (const std::string& file : options.maps) {
    maps.push_back(sound_maps::read_sound_map(file));
    if (!explorer::has_webassembly()) {
      warn_of_small_vibrations(maps.back(), "the page of a program that was built without WebAssembly");
    }
  }
  web::write_page(options.page.string(),
                  explorer::page(maps, voices::shortest_delay(), proxies_of_maps(options, maps)));
  return loop::exit_finished;
}

}  // namespace

Command explore_command() {
  return make_command<ExploreOptions>("explore", "make a web page on which the bodies of sound maps are struck",
                                      Ranks::one, declare, explore);
}

}  // namespace idiophone::app
