#include "commands.hpp"
#include "idiophone/foundation/web/page_file.hpp"
#include "idiophone/instruments/explorer/explorer_page.hpp"
#include "idiophone/instruments/proxy_bodies/proxy_bodies.hpp"
#include "idiophone/instruments/sound_maps/sound_map_file.hpp"
#include "idiophone/instruments/voices/performance.hpp"
#include "idiophone/run/bodies/read_run_deck.hpp"
#include "idiophone/run/loop/stop.hpp"
#include "idiophone/scene/find_body.hpp"

namespace idiophone::app {

namespace {

/// Of the bodies of the maps, or none.
std::vector<explorer::ProxyLevels> proxies_of_maps(const ExploreOptions& options,
                                                   const std::vector<sound_maps::SoundMap>& maps) {
  std::vector<explorer::ProxyLevels> proxies;
  if (!options.proxies.empty()) {
    const scene::Scene scene = bodies::read_deck(options.proxies, options.overrides, MPI_COMM_WORLD);
    for (const sound_maps::SoundMap& map : maps) {
      proxies.push_back(proxy_bodies::proxy_levels(scene, scene::find_body(scene.bodies, map.body), options.levels));
    }
  }
  return proxies;
}

}  // namespace

int explore(const ExploreOptions& options) {
  std::vector<sound_maps::SoundMap> maps;
  for (const std::string& file : options.maps) {
    maps.push_back(sound_maps::read_sound_map(file));
  }
  web::write_page(options.page, explorer::page(maps, voices::shortest_delay(), proxies_of_maps(options, maps)));
  return loop::exit_finished;
}

}  // namespace idiophone::app
