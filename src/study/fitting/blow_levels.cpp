#include "blow_levels.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/foundation/deck/suggestion.hpp"
#include "idiophone/instruments/sound_maps/blow.hpp"
#include "idiophone/instruments/sound_maps/modal_radiation.hpp"
#include "idiophone/instruments/sound_maps/solid_radiation.hpp"
#include "idiophone/scene/find_body.hpp"
#include "idiophone/scene/still_receivers.hpp"
#include "idiophone/study/levels/levels.hpp"

namespace idiophone::fitting {

namespace {

constexpr double hearing_threshold = 20e-6;  // Pa

std::vector<std::string> names_of_receivers(const scene::Scene& scene) {
  std::vector<std::string> names;
  std::ranges::transform(scene::still_receivers(scene.listeners), std::back_inserter(names),
                         &scene::StillReceiver::name);
  return names;
}

void require_listeners(const scene::Scene& scene, const std::vector<std::string>& listeners) {
  const std::vector<std::string> known = names_of_receivers(scene);
  for (const std::string& name : listeners) {
    if (std::ranges::find(known, name) == known.end()) {
      throw std::runtime_error(fmt::format("{}: no listener is called '{}'{}; the deck has {}", scene.deck.string(),
                                           name, deck::suggestion(name, known),
                                           known.empty() ? "none" : fmt::format("{}", fmt::join(known, ", "))));
    }
  }
}

/// Refuses plucks or bows on a body.
template <class Loads>
void require_none(const Loads& loads, std::size_t body) {
  for (const auto& load : loads) {
    if (load.body == body) {
      throw deck::DeckError(load.place.where,
                            fmt::format("load {} is no force that ends, and the level of a blow is wanted: it needs "
                                        "loads of type force",
                                        load.name));
    }
  }
}

/// The forces on a body. A map knows the sound of nothing else.
std::vector<sound_maps::Blow> blows_on(const scene::Scene& scene, std::size_t body) {
  require_none(scene.plucks, body);
  require_none(scene.bows, body);
  std::vector<sound_maps::Blow> blows;
  for (const scene::ForcePulse& pulse : scene.pulses) {
    const double strength = pulse.force.norm();
    if (pulse.body == body && strength > 0.0) {
      blows.push_back({.at = pulse.place.at,
                       .direction = pulse.force / strength,
                       .force = [signal = pulse.signal, strength](double time) { return strength * signal.at(time); },
                       .duration = std::min(pulse.signal.end(), scene.time.duration)});
    }
  }
  if (blows.empty()) {
    throw deck::DeckError(scene.bodies[body].where,
                          fmt::format("no load strikes body {}, and the level of a blow is wanted: give it a load "
                                      "with a force",
                                      scene.bodies[body].name));
  }
  return blows;
}

/// As `idiophone map` makes it.
sound_maps::SoundMap radiating_map(const scene::Scene& scene, sound_maps::SolvedSolid solved) {
  constexpr std::size_t rings_of_directions = 16;
  sound_maps::SoundMap map = sound_maps::map_of(scene, std::move(solved), eigenmodes::Estimates::none);
  map.sphere = sound_maps::sphere_of_directions(rings_of_directions);
  sound_maps::add_radiation(map, scene, sound_maps::solid_radiation(map, scene.radiation, {}).radiation, MPI_COMM_SELF);
  return map;
}

}  // namespace

std::vector<double> blow_levels(const scene::Scene& scene, const std::string& body,
                                const std::vector<std::string>& listeners, sound_maps::SolvedSolid solved) {
  require_listeners(scene, listeners);
  const std::vector<sound_maps::Blow> blows = blows_on(scene, scene::find_body(scene.bodies, body));
  const sound_maps::SoundMap map = radiating_map(scene, std::move(solved));
  const auto samples = static_cast<std::size_t>(std::lround(scene.time.duration * scene.audio.rate));
  std::vector<double> found;
  for (const std::string& name : listeners) {
    const auto ear = std::ranges::find(map.listeners, name, &sound_maps::MapListener::name) - map.listeners.begin();
    std::vector<double> sound(samples);
    for (const sound_maps::Blow& blow : blows) {
      const std::vector<double> one =
          sound_maps::sound_of(blow, map, static_cast<std::size_t>(ear), scene.audio.rate, samples);
      std::ranges::transform(sound, one, sound.begin(), std::plus());
    }
    found.push_back(levels::levels_of(sound, scene.audio.rate, hearing_threshold).exposure);
  }
  return found;
}

}  // namespace idiophone::fitting
