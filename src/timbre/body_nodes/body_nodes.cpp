#include "idiophone/timbre/body_nodes/body_nodes.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <array>
#include <exception>
#include <numbers>
#include <utility>

#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/instruments/proxies/proxy.hpp"
#include "idiophone/instruments/proxy_bodies/proxy_bodies.hpp"
#include "idiophone/instruments/sound_maps/blow.hpp"
#include "idiophone/instruments/sound_maps/resonators.hpp"
#include "idiophone/instruments/sound_maps/small_vibrations.hpp"
#include "idiophone/instruments/sound_maps/sound_map_file.hpp"
#include "idiophone/scene/find_body.hpp"
#include "idiophone/timbre/nodes/node_types.hpp"
#include "idiophone/timbre/nodes/read_once.hpp"

namespace idiophone::timbre {

namespace {

/// An argument that is a vector of three numbers.
Vector3 three_numbers(const Call& call, std::size_t argument, const char* name) {
  const std::vector<double>& numbers = call.constants[argument];
  if (numbers.size() != 3) {
    throw deck::DeckError(call.where, fmt::format("`{}` is a vector of 3 numbers, found {}", name, numbers.size()));
  }
  return {numbers[0], numbers[1], numbers[2]};
}

Vector3 unit_vector_of(const Call& call, std::size_t argument, const char* name) {
  const Vector3 vector = three_numbers(call, argument, name);
  if (!(vector.norm() > 0.0)) {
    throw deck::DeckError(call.where, fmt::format("`{}` must not be 0 0 0", name));
  }
  return vector.normalized();
}

/// Whatever is wrong with a file that a tree names is a mistake of the tree.
template <class Work>
auto at_place_of(const Call& call, const Work& work) {
  try {
    return work();
  } catch (const std::exception& error) {
    throw deck::DeckError(call.where, error.what());
  }
}

struct MappedBody {
  using Arguments = std::array<double, 1>;  // force
  sound_maps::Resonators resonators;

  double step(const Moment& /*moment*/, const Arguments& arguments) { return resonators.step(arguments[0]); }
};

std::unique_ptr<Node> sound_map(const Call& call) {
  const auto map = at_place_of(
      call, [&] { return read_once<sound_maps::SoundMap>(call.folder / call.texts[0], sound_maps::read_sound_map); });
  if (map->listeners.empty()) {
    throw deck::DeckError(call.where, call.texts[0] + " has no listener");
  }
  if (map->stretching.exists()) {
    spdlog::warn("{}: the node map {}", call.texts[0], sound_maps::without_large_amplitudes);
  }
  const std::vector<double> participation =
      sound_maps::participation(*map, three_numbers(call, 2, "at"), unit_vector_of(call, 3, "direction"));
  return component_node(std::vector<MappedBody>(
      call.width, MappedBody{sound_maps::Resonators(*map, participation, 0, call.sound_start.rate)}));
}

/// What all proxies of one body share.
struct ProxyBody {
  std::shared_ptr<const proxies::Lattice> lattice;
  Vector3 listener;  ///< from the centre of mass, m
  double air_density;
};

/// @param name  of the body; empty for the first
ProxyBody read_proxy_body(const std::filesystem::path& deck, const std::string& name) {
  const scene::Scene scene = scene::read_deck(deck);
  const std::size_t body = scene::find_body(scene.bodies, name);
  if (scene.listeners.empty()) {
    throw std::runtime_error(deck.string() + " has no listener");
  }
  const auto lattice = proxy_bodies::proxy_levels(scene, body, 1, proxy_bodies::Springs::van_gelder).front();
  const scene::Listener& listener = scene.listeners.front();
  const Vector3 ear = listener.place(listener.receivers.front(), 0.0).position;
  return {lattice, ear - lattice->body_inertia().centre, scene.radiation.air.density};
}

/// A proxy as proxies::Engine renders it, for a force that comes sample by sample.
class ProxySound {
 public:
  using Arguments = std::array<double, 1>;  // force

  ProxySound(const ProxyBody& body, const Vector3& at, Vector3 direction, int rate)
      : proxy_(body.lattice, {.rate = static_cast<double>(rate)}),
        contact_(body.lattice->contact_at(at)),
        direction_(std::move(direction)),
        gain_(body.air_density * rate / (2.0 * std::numbers::pi * body.listener.norm())) {
    proxy_.face(body.listener);
  }

  double step(const Moment& /*moment*/, const Arguments& arguments) {
    const std::array forces = {proxies::PointForce{contact_, arguments[0] * direction_}};
    proxy_.advance(std::span(forces).first(arguments[0] == 0.0 ? 0 : 1));
    const double before = std::exchange(volume_velocity_, proxy_.facing_volume_velocity());
    return gain_ * (volume_velocity_ - before);
  }

 private:
  proxies::Proxy proxy_;
  proxies::Contact contact_;
  Vector3 direction_;
  double gain_;  // from a change of the volume velocity to pressure, Pa s/m3
  double volume_velocity_ = 0.0;
};

std::unique_ptr<Node> proxy(const Call& call) {
  const Vector3 at = three_numbers(call, 3, "at");
  const Vector3 direction = unit_vector_of(call, 4, "direction");
  return at_place_of(call, [&] {
    const auto read = [](const std::filesystem::path& deck_and_body) {
      return read_proxy_body(deck_and_body.parent_path(), deck_and_body.filename().string());
    };
    const auto body = read_once<ProxyBody>(call.folder / call.texts[0] / call.texts[1], read);
    return component_node(call.states(
        [&](std::size_t /*component*/) { return ProxySound(*body, at, direction, call.sound_start.rate); }));
  });
}

std::vector<NodeType> types_of_bodies() {
  using enum Argument::Kind;
  const auto a_second = [](const Call& /*call*/) { return 1.0; };  // longer than the beats of modes are silent
  return {
      {.name = "map",
       .arguments = {{"file", text}, {"force", signal}, {"at", vector}, {"direction", vector}},
       .description = "sound (Pa) of a body by its sound map, where a force (N) acts at a place (m) in a direction",
       .make = sound_map,
       .ends_with = EndsWith::first,
       .memory = a_second},
      {.name = "proxy",
       .arguments = {{"deck", text}, {"body", text}, {"force", signal}, {"at", vector}, {"direction", vector}},
       .description = "the same by a mass-spring proxy of a body of a deck",
       .make = proxy,
       .ends_with = EndsWith::first,
       .memory = a_second},
  };
}

}  // namespace

void add_body_nodes() {
  static const bool added = [] {
    add_node_types(types_of_bodies());
    return true;
  }();
  static_cast<void>(added);
}

}  // namespace idiophone::timbre
