#pragma once
// All surfaces of a deck that reflect sound.

#include <string>
#include <vector>

#include "idiophone/air/harmonic/boundary_elements.hpp"
#include "idiophone/scene/radiation_section.hpp"
#include "idiophone/scene/solids.hpp"

namespace idiophone::harmonic {

/// Bodies where the deck puts them, obstacles, and the floor of `radiation`.
struct AcousticSurface {
  harmonic::Boundary boundary;
  std::vector<std::string> parts;     ///< names of bodies, then obstacles
  std::vector<Index> first_triangle;  ///< of each part, and one past the last: [parts + 1]
};

/// Meshes everything. Half-spaces have no surface and are left out. Call on one rank.
/// @throws deck::DeckError where a mesh can't be read
[[nodiscard]] AcousticSurface acoustic_surface(const scene::Solids& solids, const std::optional<scene::Floor>& floor);

}  // namespace idiophone::harmonic
