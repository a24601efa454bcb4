#pragma once
// Decks of ideal bodies, for sound maps.

#include "idiophone/instruments/sound_maps/ideal_body.hpp"
#include "idiophone/scene/scene.hpp"

namespace idiophone::sound_maps {

struct IdealDeck {
  scene::Scene scene;  ///< name, listeners and radiation; without bodies
  std::vector<IdealBody> bodies;
};

/// Whether a deck has ideal bodies: the key `ideal_bodies`.
/// @throws deck::DeckError if it is no YAML; std::runtime_error if the file can't be read
[[nodiscard]] bool has_ideal_bodies(const std::filesystem::path& deck, const std::vector<std::string>& overrides);

/// Reads and validates a deck of ideal bodies: name, ideal_bodies, listeners and radiation (docs/use/sound_map.md).
/// @throws deck::DeckError with every mistake found, each with its place; std::runtime_error if the file can't be read
[[nodiscard]] IdealDeck read_ideal_deck(const std::filesystem::path& deck, const std::vector<std::string>& overrides);

/// The deck with the overrides in their places and the defaults of the keys that it leaves out: YAML.
/// @throws as read_ideal_deck()
[[nodiscard]] std::string resolved_ideal_deck(const std::filesystem::path& deck,
                                              const std::vector<std::string>& overrides);

}  // namespace idiophone::sound_maps
