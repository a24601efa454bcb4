#pragma once
// The contents of a deck, validated and with defaults. Plain data. Parts that have to be checked against the mesh (a
// group's name, a point on the body) keep their places in the deck.

#include <filesystem>
#include <string>
#include <vector>

#include "idiophone/foundation/types.hpp"
#include "idiophone/scene/body.hpp"
#include "idiophone/scene/contact_sections.hpp"
#include "idiophone/scene/gauge_section.hpp"
#include "idiophone/scene/joint_section.hpp"
#include "idiophone/scene/listeners.hpp"
#include "idiophone/scene/load_sections.hpp"
#include "idiophone/scene/material.hpp"
#include "idiophone/scene/radiation_section.hpp"
#include "idiophone/scene/settings.hpp"

namespace idiophone::scene {

/// The contents of a deck.
struct Scene {
  std::string name;
  std::filesystem::path deck;          ///< path of the file
  std::string deck_text;               ///< verbatim
  std::vector<std::string> overrides;  ///< the --set arguments, verbatim
  Time time;
  std::vector<Material> materials;  ///< the deck's, then the shipped ones (shipped_materials.hpp)
  std::vector<Body> bodies;         ///< the computed ones
  std::vector<RecordedBody> recorded_bodies;
  std::vector<ForcePulse> pulses;
  std::vector<Pluck> plucks;
  std::vector<Wind> winds;
  std::vector<Bow> bows;
  std::vector<Obstacle> obstacles;
  std::vector<Contact> contacts;
  std::vector<Joint> joints;
  std::vector<Gauge> gauges;
  Vector3 gravity = Vector3::Zero();  ///< m/s2
  std::vector<Listener> listeners;
  Audio audio;
  Radiation radiation;
  Output output;
  std::vector<ReferenceSet> references;
};

/// Reads and validates a deck.
/// @param deck       the YAML file
/// @param overrides  "key.path=value" each, validated like the deck itself
/// @throws deck::DeckError that lists all mistakes with their places; std::runtime_error if the file can't be read.
[[nodiscard]] Scene read_deck(const std::filesystem::path& deck, const std::vector<std::string>& overrides = {});

}  // namespace idiophone::scene
