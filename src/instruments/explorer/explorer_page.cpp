#include "idiophone/instruments/explorer/explorer_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <vector>

#include "explorer_page_files.hpp"
#include "explorer_webassembly.hpp"
#include "idiophone/foundation/web/web_page.hpp"
#include "idiophone/solids/modal_bodies/rotation_limit.hpp"
#include "proxy_data.hpp"

namespace idiophone::explorer {

namespace {

using nlohmann::json;

void require_listeners(std::span<const sound_maps::SoundMap> maps) {
  const sound_maps::SoundMap& first = maps.front();
  if (first.listeners.empty() || first.listeners.size() > 2) {
    throw std::runtime_error(fmt::format("the sound map of {} has {} receivers; the page needs one, or two for stereo",
                                         first.body, first.listeners.size()));
  }
  for (const sound_maps::SoundMap& map : maps) {
    if (!std::ranges::equal(map.listeners, first.listeners, {}, &sound_maps::MapListener::position,
                            &sound_maps::MapListener::position)) {
      throw std::runtime_error(fmt::format(
          "the sound maps of {} and {} have different listeners; take maps of one deck", first.body, map.body));
    }
  }
}

json position_of(const sound_maps::MapListener& listener) {
  return std::vector<double>(listener.position.begin(), listener.position.end());
}

/// The air, and the positions of the receivers (m): those of the maps, or without maps one before the origin.
json surroundings_of(std::span<const sound_maps::SoundMap> maps) {
  const sound_maps::SoundMap nothing;
  const sound_maps::SoundMap& first = maps.empty() ? nothing : maps.front();
  json positions = json::array();
  for (const sound_maps::MapListener& listener : first.listeners) {
    positions.push_back(position_of(listener));
  }
  if (maps.empty()) {
    positions.push_back({0.3, -0.5, 0.5});
  }
  return {{"listeners", positions}, {"air", {{"density", first.air_density}, {"speed", first.air_speed}}}};
}

/// Shapes as whole numbers up to 32767, and what each mode's are to be multiplied by.
void add_shapes(json& body, const sound_maps::SoundMap& map) {
  constexpr float largest_whole = 32767.0F;
  std::vector<std::int16_t> shapes;
  std::vector<double> scales;
  for (std::size_t mode = 0; mode < map.modes(); ++mode) {
    float largest = 0.0F;
    for (const float value : map.shape_of(mode)) {
      largest = std::max(largest, std::abs(value));
    }
    const float scale = largest > 0.0F ? largest / largest_whole : 1.0F;
    for (const float value : map.shape_of(mode)) {
      shapes.push_back(static_cast<std::int16_t>(std::lround(value / scale)));
    }
    scales.push_back(scale);
  }
  body["shape"] = web::encoded(shapes);
  body["shape_scale"] = web::encoded(scales);
}

void add_surface(json& body, const sound_maps::SoundMap& map) {
  std::vector<float> vertices;
  for (const Vector3& vertex : map.vertices) {
    for (const double coordinate : vertex) {
      vertices.push_back(static_cast<float>(coordinate));
    }
  }
  std::vector<std::uint32_t> triangles;
  for (const auto& triangle : map.triangles) {
    triangles.insert(triangles.end(), triangle.begin(), triangle.end());
  }
  body["vertices"] = web::encoded(vertices);
  body["triangles"] = web::encoded(triangles);
}

/// H is symmetric, and most of its numbers are zero: each pair of modes that has one is written once.
json stretching_of(const modal_bodies::Stretching& stretching, std::size_t modes) {
  std::vector<std::uint32_t> places;
  std::vector<float> values;
  for (std::size_t place = 0; place < stretching.quadratic.size(); ++place) {
    const bool is_first_of_both = place / modes % modes <= place % modes;
    if (is_first_of_both && stretching.quadratic[place] != 0.0) {
      places.push_back(static_cast<std::uint32_t>(place));
      values.push_back(static_cast<float>(stretching.quadratic[place]));
    }
  }
  const auto in_single_precision = [](const std::vector<double>& numbers) {
    return web::encoded(std::vector<float>(numbers.begin(), numbers.end()));
  };
  return {{"linear", in_single_precision(stretching.linear)},
          {"rotation", in_single_precision(stretching.rotation)},
          {"places", web::encoded(places)},
          {"values", web::encoded(values)}};
}

json body_of(const sound_maps::SoundMap& map) {
  json body = {{"name", map.body},
               {"frequency", web::encoded(map.frequency)},
               {"material_decay", web::encoded(map.material_decay)},
               {"radiation_decay", web::encoded(map.radiation_decay)},
               {"airDensity", map.air_density},
               {"mass", map.mass},
               {"proxies", json::array()},
               {"listeners", json::array()}};
  if (map.material) {
    body["young"] = map.material->young;
    body["poisson"] = map.material->poisson;
  }
  for (const sound_maps::MapListener& listener : map.listeners) {
    body["listeners"].push_back({{"name", listener.name},
                                 {"delay", listener.delay},
                                 {"position", position_of(listener)},
                                 {"pressure", web::encoded(listener.pressure)}});
  }
  if (map.stretching.exists()) {
    body["stretching"] = stretching_of(map.stretching, map.modes());
  }
  add_surface(body, map);
  add_shapes(body, map);
  return body;
}

}  // namespace

bool has_webassembly() {
  return !webassembly.empty();
}

std::string page(std::span<const sound_maps::SoundMap> maps, double shortest_delay,
                 std::span<const ProxyLevels> proxies) {
  if (!maps.empty()) {
    require_listeners(maps);
  }
  json data = surroundings_of(maps);
  data["bodies"] = json::array();
  data["shortest_delay"] = shortest_delay;
  data["largest_rotation"] = modal_bodies::largest_right_rotation;
  data["webassembly"] = web::base64(std::as_bytes(std::span(webassembly)));
  for (std::size_t body = 0; body < maps.size(); ++body) {
    json& added = data["bodies"].emplace_back(body_of(maps[body]));
    for (std::size_t level = 0; body < proxies.size() && level < proxies[body].size(); ++level) {
      added["proxies"].push_back(proxy_data(*proxies[body][level]));
    }
  }
  return web::filled_page(std::string(page_template), page_files, data);
}

}  // namespace idiophone::explorer
