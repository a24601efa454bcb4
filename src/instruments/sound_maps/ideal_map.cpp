#include "idiophone/instruments/sound_maps/ideal_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <stdexcept>

#include "formula_modes.hpp"
#include "idiophone/solids/eigenmodes/no_modes.hpp"
#include "meshed_modes.hpp"

namespace idiophone::sound_maps {

using std::numbers::pi;

namespace {

using Type = IdealBody::Type;

/// Adds mass and centre of mass. Density is taken at the middles of the triangles, before the body is put in its place.
void add_mass(SoundMap& map, const IdealBody& body) {
  const eigenmodes::PlaneField density = density_of(body);
  Vector3 moment = Vector3::Zero();
  for (const auto& [i, j, k] : map.triangles) {
    const Vector3 &a = map.vertices[i], &b = map.vertices[j], &c = map.vertices[k];
    const double area = 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
    const Vector3 middle = (a + b + c) / 3;
    const double share = area * density(middle[0], middle[1]);
    map.mass += share;
    moment += share * middle;
  }
  map.centre = moment / map.mass;
  if (body.type == Type::string || body.type == Type::bar) {
    map.mass = body.density * body.length;
  }
}

std::string kind_of(Type type) {
  switch (type) {
    case Type::membrane:
      return "membrane";
    case Type::string:
      return "string";
    case Type::bar:
      return "bar";
    case Type::plate:
      break;
  }
  return "plate";
}

bool is_supported(const IdealBody& plate) {
  return std::ranges::all_of(plate.edges, [](const std::vector<eigenmodes::PlateEdge>& sides) {
    return std::ranges::all_of(sides, [](auto side) { return side == eigenmodes::PlateEdge::supported; });
  });
}

/// Whether the modes are known in closed form.
bool has_formulas(const IdealBody& body) {
  switch (body.type) {
    case Type::membrane:
      return false;
    case Type::string:
    case Type::bar:
      return true;
    case Type::plate:
      return body.length > 0.0 && body.region.holes.empty() && is_supported(body);
  }
  return false;
}

}  // namespace

SoundMap ideal_map(const scene::Scene& scene, const IdealBody& body, int count, std::optional<double> up_to) {
  SoundMap map;
  map.name = scene.name;
  map.body = body.name;
  map.kind = kind_of(body.type);
  map.deck_text = scene.deck_text;
  map.overrides = scene.overrides;
  map.air_density = scene.radiation.air.density;
  map.air_speed = scene.radiation.air.speed;
  map.radiation = "rayleigh";
  const auto add_modes = has_formulas(body) ? add_formula_modes : add_meshed_modes;
  add_modes(map, body, {count, up_to});
  if (map.frequency.empty()) {
    add_modes(map, body, {1, std::nullopt});
    throw eigenmodes::NoModes("body '" + body.name + "'", up_to.value(), map.frequency.front());
  }
  add_mass(map, body);
  map.centre += body.position;
  for (Vector3& vertex : map.vertices) {
    vertex += body.position;
  }
  for (const double frequency : map.frequency) {
    map.material_decay.push_back(pi * frequency * body.friction);
  }
  return map;
}

}  // namespace idiophone::sound_maps
