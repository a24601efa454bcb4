#include "cast.hpp"

#include <fmt/format.h>
#include <mpi.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "idiophone/foundation/version.hpp"
#include "idiophone/instruments/proxy_bodies/proxy_bodies.hpp"
#include "idiophone/instruments/sound_maps/sound_map_file.hpp"
#include "idiophone/instruments/voices/buffered_voice.hpp"
#include "idiophone/instruments/voices/sound_map_voice.hpp"
#include "idiophone/run/bodies/read_run_deck.hpp"
#include "listener_check.hpp"
#include "tree_voice.hpp"

namespace idiophone::timbre {

namespace {

void require_unique(std::vector<std::string> names) {
  std::ranges::sort(names);
  const auto twice = std::ranges::adjacent_find(names);
  if (twice != names.end()) {
    throw std::runtime_error(fmt::format("there is another body with the name {}; give each file once", *twice));
  }
}

proxies::EngineOptions engine_options(const ProxySettings& settings, const scene::Scene& deck, int rate) {
  proxies::EngineOptions options = settings.engine;
  options.rate = rate;
  options.air_density = deck.radiation.air.density;
  if (settings.budget) {
    options.budget = *settings.budget * settings.speed;
  }
  return options;
}

/// How bodies move in the result whose contacts strike them.
void add_tracks(std::vector<voices::ProxyBody>& bodies, const std::filesystem::path& result) {
  if (result.empty()) {
    return;
  }
  std::vector<drivers::StruckBody> known;
  for (const voices::ProxyBody& body : bodies) {
    known.push_back({.name = body.name, .centre = body.centre});
  }
  std::vector<drivers::BodyTrack> tracks = drivers::body_tracks(result, known);
  for (std::size_t body = 0; body < bodies.size(); ++body) {
    bodies[body].track = std::move(tracks[body]);
  }
}

/// Springs are split that are longer than twice the mean length of the finest level. Others break at their masses.
proxies::Strength strength_of(const std::string& body, const ProxyLevels& levels, const PlaySettings& settings) {
  const auto found = settings.proxies.strength.find(body);
  if (found == settings.proxies.strength.end()) {
    return {};
  }
  const proxies::Lattice& finest = *levels.front();
  double sum = 0.0;
  for (const proxies::Spring& spring : finest.springs()) {
    sum += (finest.mesh().nodes[spring.b] - finest.mesh().nodes[spring.a]).norm();
  }
  return {.tensile = found->second, .shortest_spring = sum / static_cast<double>(finest.springs().size())};
}

void require_bodies(const std::map<std::string, double>& strength, const std::vector<scene::Scene>& decks) {
  for (const auto& [name, pascals] : strength) {
    const bool is_there = std::ranges::any_of(decks, [&](const scene::Scene& deck) {
      return std::ranges::find(deck.bodies, name, &scene::Body::name) != deck.bodies.end();
    });
    if (!is_there) {
      throw std::runtime_error(fmt::format("--strength {}: no deck has a body of this name", name));
    }
  }
}

/// Only the radiation models have walls.
void warn_of_walls(const scene::Scene& deck) {
  const std::string advice = "left out here; `idiophone proxies --output-folder` hears them";
  if (deck.radiation.room) {
    spdlog::warn("the walls of radiation.room are {}", advice);
  }
  if (deck.radiation.floor) {
    spdlog::warn("the reflections of radiation.floor are {}", advice);
  }
}

/// What the pieces of bodies that break fall on: half spaces alone.
voices::Ground ground_of(const scene::Scene& deck, const PlaySettings& settings) {
  voices::Ground ground{.gravity = deck.gravity};
  for (const scene::Obstacle& obstacle : deck.obstacles) {
    if (obstacle.shape == scene::Obstacle::Shape::half_space) {
      ground.floors.push_back({.at = obstacle.at, .normal = obstacle.direction});
    } else if (!settings.proxies.strength.empty()) {
      spdlog::warn("obstacle {}: pieces of bodies that break fly through it; they touch half spaces alone",
                   obstacle.name);
    }
  }
  return ground;
}

/// All bodies of all decks, which share a budget.
/// @param all_levels  [decks][bodies]
/// @param sizes       gets those of all levels
std::unique_ptr<voices::ProxyVoices> proxy_voices(const std::vector<scene::Scene>& decks,
                                                  const std::vector<std::vector<ProxyLevels>>& all_levels,
                                                  const voices::Audience& audience, const PlaySettings& settings,
                                                  int rate, std::vector<LevelSize>& sizes) {
  require_bodies(settings.proxies.strength, decks);
  const proxies::EngineOptions options = engine_options(settings.proxies, decks.front(), rate);
  proxies::Engine engine(options);
  std::vector<voices::ProxyBody> bodies;
  for (std::size_t number_of_deck = 0; number_of_deck < decks.size(); ++number_of_deck) {
    const scene::Scene& deck = decks[number_of_deck];
    const std::vector<ProxyLevels>& levels = all_levels[number_of_deck];
    proxy_bodies::warn_of_what_proxies_lack(deck);
    warn_of_walls(deck);
    for (std::size_t body = 0; body < deck.bodies.size(); ++body) {
      const std::size_t number = engine.add({.name = deck.bodies[body].name,
                                             .levels = levels[body],
                                             .priority = -static_cast<double>(bodies.size()),
                                             .strength = strength_of(deck.bodies[body].name, levels[body], settings)});
      bodies.push_back(
          {.name = deck.bodies[body].name, .centre = levels[body].front()->body_inertia().centre, .track = {}});
      for (std::size_t level = 0; level < levels[body].size(); ++level) {
        spdlog::info("{}, level {}: {:.3g} springs per second of sound", bodies.back().name, level,
                     engine.cost(number, level, 1));
        const proxies::Lattice& lattice = *levels[body][level];
        sizes.push_back({bodies.back().name, level, lattice.masses().size(), lattice.springs().size()});
      }
    }
  }
  add_tracks(bodies, settings.contacts);
  const voices::ProxyHearing hearing{.sound = settings.proxies.engine.sound,
                                     .speed_of_sound = decks.front().radiation.air.speed,
                                     .rate = rate,
                                     .budget = options.budget / settings.proxies.speed,
                                     .speed = settings.proxies.speed,
                                     .most_active = options.most_active};
  auto voices = std::make_unique<voices::ProxyVoices>(std::move(engine), std::move(bodies), audience, hearing);
  voices->fall_on(ground_of(decks.front(), settings));
  return voices;
}

}  // namespace

std::vector<std::string> Cast::names() const {
  std::vector<std::string> names;
  for (const sound_maps::SoundMap& map : maps) {
    names.push_back(map.body);
  }
  for (const scene::Scene& deck : decks) {
    std::ranges::transform(deck.bodies, std::back_inserter(names), &scene::Body::name);
  }
  for (const Tree& tree : trees) {
    names.push_back(tree.file.stem().string());
  }
  return names;
}

Cast read_cast(const PlaySettings& settings) {
  Cast cast;
  for (const std::filesystem::path& file : settings.files) {
    if (file.extension() == ".h5") {
      cast.maps.push_back(sound_maps::read_sound_map(file));
    } else if (file.extension() == ".tt") {
      cast.trees.push_back(read_tree_file(file));
    } else {
      cast.decks.push_back(bodies::read_deck(file, settings.deck_overrides, MPI_COMM_SELF));
    }
  }
  require_unique(cast.names());
  return cast;
}

voices::Audience audience_of(const Cast& cast, const score::Score& score, int rate) {
  if (score.listener) {
    return {*score.listener, rate};
  }
  if (!cast.maps.empty()) {
    return voices::audience_of(cast.maps);
  }
  if (!cast.decks.empty()) {
    return {cast.decks.front().listeners.front(), rate};
  }
  return {};
}

std::vector<ProxyLevels> levels_of_all(const scene::Scene& deck, int levels) {
  std::vector<ProxyLevels> all;
  for (std::size_t body = 0; body < deck.bodies.size(); ++body) {
    all.push_back(proxy_bodies::proxy_levels(deck, body, levels));
    for (std::size_t level = 0; level < all.back().size(); ++level) {
      const proxies::Lattice& lattice = *all.back()[level];
      spdlog::info("{}, level {}: {} masses, {} springs, {} tetrahedra", deck.bodies[body].name, level,
                   lattice.masses().size(), lattice.springs().size(), lattice.mesh().tetrahedra.size());
    }
  }
  return all;
}

namespace {

Origin origin_of(const Cast& cast, const PlaySettings& settings) {
  const bool has_one_deck = cast.decks.size() == 1;
  return {.name = settings.output.stem().string(),
          .code_version = program_version,
          .deck_text = has_one_deck ? cast.decks.front().deck_text : "",
          .overrides = has_one_deck ? cast.decks.front().overrides : std::vector<std::string>{}};
}

}  // namespace

StagedCast staged(Cast cast, const PlaySettings& settings, const score::Score& score, int rate, bool is_live) {
  StagedCast staged;
  staged.origin = origin_of(cast, settings);
  std::vector<std::vector<ProxyLevels>> levels;
  for (const scene::Scene& deck : cast.decks) {
    levels.push_back(levels_of_all(deck, settings.proxies.levels));
  }
  check_listener(cast, levels, score);
  const voices::Audience audience = audience_of(cast, score, rate);
  const std::size_t channels = audience.receivers();
  std::vector<std::unique_ptr<voices::Voice>> all;
  if (!cast.maps.empty()) {
    all = voices::sound_map_voices(std::move(cast.maps), audience, rate);
  }
  const auto add = [&](std::unique_ptr<voices::Voice> voice) {
    const voices::Buffering buffering{.frames = static_cast<std::size_t>(settings.buffer_frames),
                                      .buffers = static_cast<std::size_t>(settings.buffers)};
    if (is_live) {
      voice = std::make_unique<voices::BufferedVoice>(std::move(voice), channels, rate, buffering);
    }
    all.push_back(std::move(voice));
  };
  if (!cast.decks.empty()) {
    auto proxies = proxy_voices(cast.decks, levels, audience, settings, rate, staged.levels);
    staged.proxies = proxies.get();
    if (settings.proxies.frames_per_second > 0.0) {
      proxies->take_film(settings.proxies.frames_per_second);
    }
    add(std::move(proxies));
  }
  for (Tree& tree : cast.trees) {
    std::string name = tree.file.stem().string();
    add(std::make_unique<TreeVoice>(std::move(tree), std::move(name), audience, score.seed + all.size(), rate));
  }
  staged.stage = std::make_unique<voices::Stage>(audience, std::move(all), channels, rate);
  return staged;
}

}  // namespace idiophone::timbre
