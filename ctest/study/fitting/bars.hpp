#pragma once
// Bars of meshes/bar.geo for tests of fits.

#include <filesystem>
#include <map>
#include <string>

#include "idiophone/scene/scene.hpp"

namespace idiophone::fitting {

/// A free bar of a few hexahedra, of aluminium.
/// @param sides  length, width, thickness, m
inline scene::Scene bar_scene(const Vector3& sides, double size, int order) {
  scene::Scene scene;
  scene.materials = {{"aluminium", 7e10, 0.33, 2700, {}, {}}};
  scene::Body& body = scene.bodies.emplace_back();
  body.name = "bar";
  body.mesh = std::filesystem::path(IDIOPHONE_SOURCE_DIR) / "meshes/bar.geo";
  body.parameters = {{"length", sides[0]}, {"width", sides[1]}, {"thickness", sides[2]}, {"size", size}};
  body.element = element::hex(order, order);
  return scene;
}

/// Wood: stiff along the bar.
inline scene::Material spruce() {
  scene::Material material{"spruce", 11.9e9, 0, 450, {}, {}};
  material.orthotropy = {{11.9e9, 0.93e9, 0.51e9}, {0.372, 0.435, 0.467}, {0.76e9, 0.036e9, 0.73e9}};
  return material;
}

}  // namespace idiophone::fitting
