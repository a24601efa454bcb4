#include "idiophone/explorer/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <vector>

#include "idiophone/web_page.hpp"
#include "page_files.hpp"

namespace idiophone::explorer {

namespace {

using nlohmann::json;

void require_listeners(std::span<const store::SoundMap> maps) {
  const store::SoundMap& first = maps.front();
  if (first.listeners.empty() || first.listeners.size() > 2) {
    throw std::runtime_error(fmt::format("the sound map of {} has {} receivers; the page needs one, or two for stereo",
                                         first.body, first.listeners.size()));
  }
  for (const store::SoundMap& map : maps) {
    if (!std::ranges::equal(map.listeners, first.listeners, {}, &store::MapListener::position,
                            &store::MapListener::position)) {
      throw std::runtime_error(fmt::format(
          "the sound maps of {} and {} have different listeners; take maps of one deck", first.body, map.body));
    }
  }
}

/// Shapes as whole numbers up to 32767, and what each mode's are to be multiplied by.
void add_shapes(json& body, const store::SoundMap& map) {
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
  body["shape"] = encoded(shapes);
  body["shape_scale"] = encoded(scales);
}

void add_surface(json& body, const store::SoundMap& map) {
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
  body["vertices"] = encoded(vertices);
  body["triangles"] = encoded(triangles);
}

json body_of(const store::SoundMap& map) {
  json body = {{"name", map.body},
               {"frequency", encoded(map.frequency)},
               {"material_decay", encoded(map.material_decay)},
               {"radiation_decay", encoded(map.radiation_decay)},
               {"listeners", json::array()}};
  for (const store::MapListener& listener : map.listeners) {
    body["listeners"].push_back(
        {{"name", listener.name}, {"delay", listener.delay}, {"pressure", encoded(listener.pressure)}});
  }
  add_surface(body, map);
  add_shapes(body, map);
  return body;
}

}  // namespace

std::string page(std::span<const store::SoundMap> maps, double shortest_delay) {
  require_listeners(maps);
  json data = {{"bodies", json::array()}, {"shortest_delay", shortest_delay}};
  for (const store::SoundMap& map : maps) {
    data["bodies"].push_back(body_of(map));
  }
  return filled_page(std::string(page_template), page_files, data);
}

}  // namespace idiophone::explorer
