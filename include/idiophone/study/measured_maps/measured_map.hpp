#pragma once
// A sound map from recordings of blows at several points of a body (docs/method/sound_map.md, Measured bodies).

#include "idiophone/instruments/sound_maps/sound_map.hpp"
#include "idiophone/study/measured_maps/measured_deck.hpp"

namespace idiophone::measured_maps {

/// Which partials become modes.
struct WantedPartials {
  double up_to = 20000.0;    ///< Hz
  std::optional<int> count;  ///< at most so many, the lowest
};

/// Meshes a body, reads its recordings and makes its sound map, complete except for `code_version`. Call on one rank.
/// @throws deck::DeckError, pointing at a key of the deck, as mesh::read_mesh(), for a point that is not on the
///         surface, and for recordings that can't be used: clipped, silent, of different rates, too short, with a
///         number of channels that is not that of the microphones, or without partials;
///         std::runtime_error for files that can't be read
[[nodiscard]] sound_maps::SoundMap measured_map(const MeasuredDeck& deck, const MeasuredBody& body,
                                                const WantedPartials& wanted);

}  // namespace idiophone::measured_maps
