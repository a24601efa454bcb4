#pragma once
// Whether bodies and listeners stand where the sound can be found.

#include <string>
#include <vector>

#include "idiophone/air/propagation/surroundings.hpp"
#include "idiophone/scene/acoustics.hpp"

namespace idiophone::propagation {

/// How the sound at listeners is found.
enum class Hearing {
  straight_ways,  ///< triangles are points, whose sound travels straight through everything
  grid,           ///< waves on a grid
  exact           ///< boundary elements, which hold at any distance
};

/// That of the scene's radiation model.
[[nodiscard]] Hearing hearing_of(const scene::Radiation& radiation);

/// What a user should know:
/// - a listener comes so near to a surface that its level is doubtful: within a twentieth of a wavelength at 1 kHz, or
///   within the edge of a triangle or a cell; or its path goes through a body or an obstacle
/// - with straight ways: a part stands in the way from more than half of a body to a listener
/// - a body reaches behind the floor
/// Listeners attached to bodies are where they are at time 0. Call on one rank.
/// @throws deck::DeckError with the places of the deck: a listener begins inside a body or an obstacle, a body is
///         behind the floor by more than half, or outside the room
[[nodiscard]] std::vector<std::string> placement_warnings(const scene::Acoustics& acoustics, const Surroundings& around,
                                                          Hearing hearing);

}  // namespace idiophone::propagation
