#pragma once
// Which elements of a mesh have which material, by its physical groups.

#include <span>
#include <vector>

#include "gmsh_mesh.hpp"

namespace idiophone::mesh {

/// @param loaded  nodes, elements and groups, in the file's order
/// @return [elements] as Mesh::regions
/// @throws deck::DeckError, pointing at the region, when the file has no such group of elements, or an element is in
///         two regions; pointing at the first one, when elements are in none. It names elements and groups.
[[nodiscard]] std::vector<Index> regions_by_group(const scene::Body& body, const GmshMesh& loaded);

// The two steps of it, for a mesh of which a rank has some of the elements.

/// [elements] The region of each of these elements, or -1 for none.
/// @param loaded  may lack nodes; messages then lack places
/// @throws deck::DeckError, pointing at the region, when an element is in two
[[nodiscard]] std::vector<Index> found_regions(const scene::Body& body, const GmshMesh& loaded);

/// @param loaded   with these elements
/// @param regions  of these elements
/// @param counts   [regions + 1] elements of the whole mesh in each region, and in none
/// @throws deck::DeckError, pointing at the region, when one has no elements; pointing at the first one, when elements
///         are in none, if one of these is
void require_regions(const scene::Body& body, const GmshMesh& loaded, std::span<const Index> regions,
                     std::span<const Index> counts);

/// [regions + 1] How many of the elements are in each region, and in none.
[[nodiscard]] std::vector<Index> region_counts(const scene::Body& body, std::span<const Index> regions);

}  // namespace idiophone::mesh
