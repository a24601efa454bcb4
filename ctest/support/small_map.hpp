#pragma once
// A sound map with all that a sound map can hold.

#include "idiophone/instruments/sound_maps/sound_map.hpp"
#include "shared_folder.hpp"

namespace idiophone::sound_maps {

/// Two modes of a tetrahedron's surface, one listener, four directions.
inline SoundMap small_map() {
  SoundMap map;
  map.name = "deck";
  map.body = "plate";
  map.kind = "solid";
  map.code_version = "0.2.0";
  map.deck_text = "name: deck # gr\xc3\xbc\xc3\x9f\n";
  map.overrides = {"a=1"};
  map.resolved_deck = "name: deck\na: 1\n";
  map.material = {"steel", 7850, 2e11, 0.3};
  map.mass = 1.5;
  map.centre = {0.1, 0.2, 0.3};
  map.radiation = "kirchhoff";
  map.frequency = {100.0 / 3, 200};
  map.material_decay = {1.0 / 7, 2};
  map.radiation_decay = {0, 1.0 / 3};
  map.scalable = {.mesh = "0123456789abcdef",
                  .mesh_shape = MeshShape{.kind = "tet4, 5 nodes, 2 elements",
                                          .middle = {0.1, 0.2, 0.3},
                                          .size = 0.4,
                                          .pattern = Eigen::Matrix<double, 6, 4>::Identity()},
                  .held = "rim xyz",
                  .stiffness = ScalableModes::Stiffness::Identity() * 2e11,
                  .lossless_frequency = {100.0 / 3, 200}};
  map.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1.0 / 3}};
  map.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  for (int i = 0; i < 24; ++i) {
    map.shape.push_back(static_cast<float>(support::value_of(i, 1)));
  }
  map.listeners = {{"ears.left", {0, 0, 1}, 0.003, {{1.0 / 3, 2}, {3, 4}}}};
  map.sphere = {.distance = 1,
                .rings = 2,
                .azimuths = 2,
                .direction = {{0.6, 0, 0.8}, {-0.6, 0, 0.8}, {0.6, 0, -0.8}, {-0.6, 0, -0.8}},
                .weight = {3, 3, 3, 3.5},
                .pressure = {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 6}, {6, 7}, {7, 1.0 / 9}}};
  return map;
}

}  // namespace idiophone::sound_maps
