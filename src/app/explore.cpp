#include "commands.hpp"
#include "idiophone/explorer/page.hpp"
#include "idiophone/lattices/proxy_bodies.hpp"
#include "idiophone/playing/performance.hpp"
#include "idiophone/scene/alone.hpp"
#include "page_file.hpp"
#include "read_deck.hpp"
#include "stop.hpp"

namespace idiophone::app {

namespace {

/// Of the bodies of the maps, or none.
std::vector<explorer::ProxyLevels> proxies_of_maps(const ExploreOptions& options,
                                                   const std::vector<store::SoundMap>& maps) {
  std::vector<explorer::ProxyLevels> proxies;
  if (!options.proxies.empty()) {
    const scene::Scene scene = read_deck(options.proxies, options.overrides, MPI_COMM_WORLD);
    for (const store::SoundMap& map : maps) {
      proxies.push_back(lattices::proxy_levels(scene, scene::find_body(scene, map.body), options.levels));
    }
  }
  return proxies;
}

}  // namespace

int explore(const ExploreOptions& options) {
  std::vector<store::SoundMap> maps;
  for (const std::string& file : options.maps) {
    maps.push_back(store::read_sound_map(file));
  }
  write_page(options.page, explorer::page(maps, playing::shortest_delay(), proxies_of_maps(options, maps)));
  return exit_finished;
}

}  // namespace idiophone::app
