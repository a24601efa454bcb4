#pragma once
// What moves in a deck.

#include <span>

#include "idiophone/foundation/types.hpp"
#include "idiophone/scene/body.hpp"
#include "idiophone/scene/contact_sections.hpp"
#include "idiophone/scene/gauge_section.hpp"
#include "idiophone/scene/joint_section.hpp"
#include "idiophone/scene/load_sections.hpp"
#include "idiophone/scene/material.hpp"

namespace idiophone::scene {

struct Scene;

/// The computed bodies of a scene and what acts on them. A view: the scene has to outlive it.
struct Solids {
  Solids() = default;
  Solids(const Scene& scene);  // NOLINT(google-explicit-constructor): a scene is also its solids

  std::span<const Body> bodies;
  std::span<const Material> materials;
  std::span<const ForcePulse> pulses;
  std::span<const Pluck> plucks;
  std::span<const Wind> winds;
  std::span<const Bow> bows;
  std::span<const Obstacle> obstacles;
  std::span<const Contact> contacts;
  std::span<const Joint> joints;
  std::span<const Gauge> gauges;
  Vector3 gravity = Vector3::Zero();  ///< m/s2
  double air_density = 0.0;           ///< kg/m3
  double max_frequency = 0.0;         ///< of the sound, Hz

  /// One body and what holds it, by itself: no loads, contacts, joints, gauges or other bodies.
  [[nodiscard]] Solids alone(std::size_t body) const;
};

}  // namespace idiophone::scene
