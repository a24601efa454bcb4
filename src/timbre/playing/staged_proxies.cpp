#include "staged_proxies.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "idiophone/instruments/proxy_bodies/proxy_bodies.hpp"

namespace idiophone::timbre {

namespace {

/// @param shared  with sound maps, or null
proxies::EngineOptions engine_options(const ProxySettings& settings, const scene::Scene& deck, int rate,
                                      const std::shared_ptr<voices::SharedBudget>& shared) {
  proxies::EngineOptions options = settings.engine;
  options.rate = rate;
  options.air_density = deck.radiation.air.density;
  if (settings.budget) {
    options.budget = *settings.budget * settings.speed;
  }
  if (shared) {
    options.others = [shared, speed = settings.speed](double priority) {
      return speed * shared->maps.at_least(priority);
    };
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

}  // namespace

std::unique_ptr<voices::ProxyVoices> proxy_voices(const std::vector<scene::Scene>& decks,
                                                  const std::vector<std::vector<ProxyLevels>>& all_levels,
                                                  const voices::Audience& audience, const PlaySettings& settings,
                                                  int rate, const std::shared_ptr<voices::SharedBudget>& shared,
                                                  std::vector<LevelSize>& sizes) {
  require_bodies(settings.proxies.strength, decks);
  const proxies::EngineOptions options = engine_options(settings.proxies, decks.front(), rate, shared);
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
                                     .most_active = options.most_active,
                                     .shared = shared};
  auto voices = std::make_unique<voices::ProxyVoices>(std::move(engine), std::move(bodies), audience, hearing);
  voices->fall_on(ground_of(decks.front(), settings));
  return voices;
}

}  // namespace idiophone::timbre
