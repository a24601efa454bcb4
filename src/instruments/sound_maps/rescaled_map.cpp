#include "idiophone/instruments/sound_maps/rescaled_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "heard_alike.hpp"
#include "idiophone/scene/joined_bodies.hpp"
#include "idiophone/solids/eigenmodes/material_damping.hpp"
#include "scaled_placement.hpp"
#include "solid_facts.hpp"

namespace idiophone::sound_maps {

namespace {

constexpr double negligible = 1e-9;  ///< relative, of numbers that should be the same

/// How much larger the new constants and lengths are.
struct Factors {
  double stiffness = 1.0;
  double density = 1.0;
  double size = 1.0;

  [[nodiscard]] double frequency() const { return std::sqrt(stiffness / density) / size; }
  [[nodiscard]] double mass() const { return density * size * size * size; }
  [[nodiscard]] double shape() const { return 1.0 / std::sqrt(mass()); }
};

void require_same(const std::string& what, const std::string& now, const std::string& before,
                  const std::filesystem::path& path, const scene::Body& body) {
  if (now != before) {
    throw deck::DeckError(
        body.where, fmt::format("bodies.{}: {} is '{}', and '{}' in {}; make the map without --rescale", body.name,
                                what, now, before, path.string()));
  }
}

/// @throws deck::DeckError unless all constants have the same factor
double stiffness_factor(const ScalableModes& now, const ScalableModes& before, const scene::Material& material,
                        const std::filesystem::path& path) {
  const double factor = now.stiffness.norm() / before.stiffness.norm();
  if (!((now.stiffness - factor * before.stiffness).norm() <= negligible * now.stiffness.norm())) {
    throw deck::DeckError(
        material.where,
        fmt::format(
            "materials.{}: the elastic constants are not those of {} times one factor: Poisson's ratio, another "
            "ratio of constants or the direction of the grain differs; make the map without --rescale",
            material.name, path.string()));
  }
  return factor;
}

/// @throws deck::DeckError unless the mesh is that of the map but for its size and place
Placement checked_placement(const ScalableModes& now, const ScalableModes& before, const std::filesystem::path& path,
                            const scene::Body& body) {
  const std::optional<Placement> placement = placement_of(now, before);
  if (!placement) {
    throw deck::DeckError(
        body.where, fmt::format("bodies.{}: its mesh is '{}', and '{}' in {}, and it is not this one times a factor{}; "
                                "make the map without --rescale",
                                body.name, now.mesh, before.mesh, path.string(),
                                before.mesh_shape ? "" : ", as far as that map of an older version tells"));
  }
  return *placement;
}

/// @param number  of the body
/// @return the body as it is now, with the old frequencies
ScalableModes checked_modes(const SoundMap& source, const std::filesystem::path& path, const scene::Scene& scene,
                            std::size_t number) {
  const scene::Body& body = scene.bodies[number];
  const std::string reason = scene::is_joined(number, scene.joints) ? "it has joints" : why_not_scalable(body);
  if (!reason.empty()) {
    throw deck::DeckError(body.where, fmt::format("bodies.{}: its modes can't be rescaled: {}; make the map without "
                                                  "--rescale",
                                                  body.name, reason));
  }
  if (!source.scalable) {
    throw std::runtime_error(
        fmt::format("{} can't be rescaled: it does not say what its modes depend on. Maps of bodies of finite elements "
                    "say it if they have one material, no prestress, supports, mass_scaling or large_amplitudes, and "
                    "were made without --in-air by this version or a later one",
                    path.string()));
  }
  ScalableModes now = scalable_modes(scene, body, mesh::read_mesh(body));
  require_same("what holds it", now.held, source.scalable->held, path, body);
  return now;
}

bool is_same_frequency(double one, double other) {
  return std::abs(one - other) <= negligible * other;
}

/// Of a modal velocity of amplitude 1, as it moves the surface less if the shapes are smaller. If the wave length grows
/// as the body, the pressure of the same motion stays at places that go with it, and grows as its size at one distance.
void scale_radiation(SoundMap& map, double shape, double size) {
  for (MapListener& listener : map.listeners) {
    std::ranges::for_each(listener.pressure, [&](auto& pressure) { pressure *= shape; });
  }
  std::ranges::for_each(map.sphere.pressure, [&](auto& pressure) { pressure *= shape * size; });
  std::ranges::for_each(map.radiation_decay, [&](double& decay) { decay *= shape * shape * size * size; });
}

void scale_modes(SoundMap& map, const Factors& factors, const scene::Damping& damping) {
  std::vector<double>& lossless = map.scalable->lossless_frequency;
  std::ranges::for_each(lossless, [&](double& frequency) { frequency *= factors.frequency(); });
  const auto vibrations = eigenmodes::damped_by(damping, lossless);
  for (std::size_t mode = 0; mode < map.modes(); ++mode) {
    map.frequency[mode] = vibrations[mode].frequency();
    map.material_decay[mode] = vibrations[mode].decay();
  }
  std::ranges::for_each(map.shape, [&](float& value) { value = static_cast<float>(value * factors.shape()); });
}

/// Moves the body to where it is now, and listeners along.
void place(SoundMap& map, const Placement& placement) {
  const auto move = [&](Vector3& point) { point = placement.of(point); };
  std::ranges::for_each(map.vertices, move);
  move(map.centre);
  for (MapListener& listener : map.listeners) {
    move(listener.position);
    listener.delay *= placement.size;
  }
}

}  // namespace

SoundMap rescaled_map(const SoundMap& source, const std::filesystem::path& path, const scene::Scene& scene,
                      std::size_t body, const std::string& resolved_deck) {
  const scene::Body& here = scene.bodies[body];
  const scene::Material& material = scene.materials[here.material];
  const ScalableModes now = checked_modes(source, path, scene, body);
  const Placement placement = checked_placement(now, *source.scalable, path, here);
  const Factors factors{.stiffness = stiffness_factor(now, *source.scalable, material, path),
                        .density = material.density / source.material->density,
                        .size = placement.size};
  SoundMap map = source;
  add_facts(map, scene, std::span(&here, 1));
  map.resolved_deck = resolved_deck;
  map.mass *= factors.mass();
  place(map, placement);
  map.scalable->mesh = now.mesh;
  map.scalable->mesh_shape = now.mesh_shape;
  map.scalable->stiffness = now.stiffness;
  scale_modes(map, factors, material.damping);
  const auto is_same_wave = [&](double one, double other) { return is_same_frequency(factors.size * one, other); };
  if (is_heard_alike(source, scene, resolved_deck, placement) &&
      std::ranges::equal(map.frequency, source.frequency, is_same_wave)) {
    scale_radiation(map, factors.shape(), factors.size);
  } else {
    map.listeners.clear();
    map.radiation_decay.clear();
    map.sphere = {};
  }
  return map;
}

}  // namespace idiophone::sound_maps
