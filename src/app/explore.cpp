#include "commands.hpp"
#include "idiophone/explorer/page.hpp"
#include "idiophone/playing/performance.hpp"
#include "page_file.hpp"
#include "stop.hpp"

namespace idiophone::app {

int explore(const ExploreOptions& options) {
  std::vector<store::SoundMap> maps;
  for (const std::string& file : options.maps) {
    maps.push_back(store::read_sound_map(file));
  }
  write_page(options.page, explorer::page(maps, playing::shortest_delay()));
  return exit_finished;
}

}  // namespace idiophone::app
