#pragma once
// All surfaces of a deck that reflect sound.

#include <optional>
#include <string>
#include <vector>

#include "idiophone/air/harmonic/boundary_elements.hpp"
#include "idiophone/scene/radiation_section.hpp"
#include "idiophone/scene/solids.hpp"

namespace idiophone::harmonic {

/// Bodies where the deck puts them, obstacles, and the floor of `radiation`. Bodies that joints tie together are one
/// part, without the triangles that joints cover (joints::covered_triangles()).
struct AcousticSurface {
  harmonic::Boundary boundary;
  std::size_t bodies = 0;             ///< how many of the parts consist of bodies: one for each of scene::assemblies()
  std::vector<std::string> parts;     ///< names of bodies, the first of joined ones; then of obstacles
  std::vector<Index> first_triangle;  ///< of each part, and one past the last: [parts + 1]
};

/// Meshes everything. Half-spaces have no surface and are left out. Call on one rank.
/// @throws deck::DeckError where a mesh can't be read; as joints::covered_triangles(); pointing at a joint, where the
/// surface of joined bodies is open
[[nodiscard]] AcousticSurface acoustic_surface(const scene::Solids& solids, const std::optional<scene::Floor>& floor);

}  // namespace idiophone::harmonic
