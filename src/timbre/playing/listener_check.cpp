#include "listener_check.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>

#include "idiophone/air/propagation/placement.hpp"

namespace idiophone::timbre {

namespace {

/// Where the first receiver comes: at the beginning, and at the points of its path.
std::vector<Vector3> places_of(const scene::Listener& listener) {
  const scene::Receiver& receiver = listener.receivers.front();
  std::vector<Vector3> places = {listener.place(receiver, 0.0).position};
  for (std::size_t i = 0; listener.path && i < listener.path->points.size(); ++i) {
    places.push_back(listener.place(receiver, listener.path->points[i].time).position);
  }
  return places;
}

/// Of a map that is heard by its far field (docs/use/play.md, The listener).
void warn_of_near_field(const sound_maps::SoundMap& map, const scene::Listener& listener) {
  const auto from_centre = [&](const Vector3& place) { return (place - map.centre).norm(); };
  const double radius = from_centre(*std::ranges::max_element(map.vertices, {}, from_centre));
  const std::vector<Vector3> places = places_of(listener);
  const double nearest = from_centre(*std::ranges::min_element(places, {}, from_centre));
  if (nearest < radius) {
    spdlog::warn(
        "listener {} comes within {:.3g} m of the centre of {} and hears it as from {:.3g} m, its largest radius: "
        "levels can be wrong; move it away, or leave `listener` out, so that the listeners of the map hear its near "
        "field",
        listener.name, nearest, map.body, radius);
  }
}

/// Ideal bodies are flat, in a rigid wall.
void warn_of_wall(const sound_maps::SoundMap& map, const scene::Listener& listener) {
  const bool has_wall = map.kind != "solid" && map.kind != "measured";
  const double wall = map.vertices.front()[2];
  if (has_wall && std::ranges::any_of(places_of(listener), [=](const Vector3& place) { return place[2] <= wall; })) {
    spdlog::warn("listener {} comes behind the wall of {}, z = {:.6g} m, where nothing of it is heard", listener.name,
                 map.body, wall);
  }
}

}  // namespace

void check_listener(const Cast& cast, const std::vector<std::vector<ProxyLevels>>& levels, const score::Score& score) {
  scene::Scene heard;  // no more than the listener
  propagation::Surroundings around;
  if (score.listener) {
    scene::Listener& listener = heard.listeners.emplace_back(*score.listener);
    listener.name = "listener";  // as in a score
    listener.receivers.front().channel = listener.name;
    for (const sound_maps::SoundMap& map : cast.maps) {
      warn_of_near_field(map, listener);
      warn_of_wall(map, listener);
      around.add(map.body, map.vertices, map.triangles);
    }
  } else if (!cast.maps.empty()) {
    for (const sound_maps::MapListener& listener : cast.maps.front().listeners) {
      scene::Listener& place = heard.listeners.emplace_back();
      place.name = listener.name;
      place.receivers = {{.channel = listener.name, .position = listener.position}};
    }
  } else if (!cast.decks.empty()) {
    heard.listeners = {cast.decks.front().listeners.front()};
  }
  for (std::size_t deck = 0; deck < cast.decks.size(); ++deck) {
    for (std::size_t body = 0; body < levels[deck].size(); ++body) {
      const proxies::TetrahedralMesh& mesh = levels[deck][body].front()->mesh();
      around.add(cast.decks[deck].bodies[body].name, mesh.nodes, mesh.surface);
    }
  }
  around.bodies = around.names.size();
  const auto hearing = propagation::Hearing::straight_ways;
  for (const std::string& warning : propagation::placement_warnings(heard, around, hearing)) {
    spdlog::warn(warning);
  }
}

}  // namespace idiophone::timbre
