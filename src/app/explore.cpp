#include <spdlog/spdlog.h>

#include <fmt/format.h>
#include <fstream>
#include <stdexcept>

#include "commands.hpp"
#include "idiophone/explorer/page.hpp"
#include "stop.hpp"

namespace idiophone::app {

int explore(const ExploreOptions& options) {
  std::vector<store::SoundMap> maps;
  for (const std::string& file : options.maps) {
    maps.push_back(store::read_sound_map(file));
  }
  const std::string text = explorer::page(maps);
  if (!(std::ofstream(options.page) << text).flush()) {
    throw std::runtime_error(fmt::format("can't write {}", options.page));
  }
  spdlog::info("{}: {:.1f} MB; open it with a browser", options.page, static_cast<double>(text.size()) * 1e-6);
  return exit_finished;
}

}  // namespace idiophone::app
