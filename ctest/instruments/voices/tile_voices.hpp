#pragma once
// A proxy that breaks, for tests of its voices.

#include <memory>
#include <utility>
#include <vector>

#include "idiophone/instruments/voices/proxy_voices.hpp"

namespace idiophone::voices {

struct Tile {
  int cells;                      ///< along each edge
  double damping;                 ///< of the masses, 1/s
  double tensile;                 ///< strength, Pa
  drivers::BodyTrack track = {};  ///< none: it stays
};

/// A tile of 60 x 60 x 5 mm about the origin, heard 1 m above it.
inline std::unique_ptr<ProxyVoices> tile_voices(const Tile& tile, int rate) {
  const auto place = [](const Vector3& at) {
    return Vector3((at - Vector3::Constant(0.5)).cwiseProduct(Vector3(0.06, 0.06, 0.005)));
  };
  const auto lattice = std::make_shared<proxies::Lattice>(
      proxies::grid_mesh({tile.cells, tile.cells, 1}, place),
      proxies::Material{.young = 1e9, .density = 1000, .damping = {.mass = tile.damping, .stiffness = 1e-6}});
  proxies::Engine engine({.rate = rate, .most_active = 500});
  engine.add({.name = "tile", .levels = {lattice}, .strength = {.tensile = tile.tensile, .shortest_spring = 1.0}});
  return std::make_unique<ProxyVoices>(
      std::move(engine), std::vector<ProxyBody>{{.name = "tile", .centre = Vector3::Zero(), .track = tile.track}},
      Audience(std::vector<HearingPoint>{{.position = {0, 0, 1}}}), ProxyHearing{.rate = rate, .most_active = 500});
}

/// A blow on the upper side (up = 1) or the lower one (up = -1), against it.
inline void strike_tile(ProxyVoices& voices, double up) {
  std::vector<resonators::ForcePiece> force(8, {.mean = 400.0});
  voices.excite(
      0,
      {.forces =
           {{.start = 20, .at = {0.005, 0.003, 0.0025 * up}, .direction = -up * Vector3::UnitZ(), .force = force}},
       .strength = {}},
      0);
}

}  // namespace idiophone::voices
