#pragma once
// Whether the corners of a polygon bound a region.

#include "idiophone/foundation/deck/mistakes.hpp"
#include "idiophone/solids/mesh/plane_mesh.hpp"

namespace idiophone::sound_maps {

/// Reports the first two corners at one place, or else the first two edges that cross, touch, or run back over each
/// other. Places are the same where they are closer than a millionth of the polygon's extent.
/// @param node     list of the corners in the deck
/// @param polygon  its corners, as many, at least 3, m
/// @return whether the polygon is simple
bool check_polygon(const deck::Node& node, const std::vector<mesh::Point2>& polygon, deck::Mistakes& mistakes);

}  // namespace idiophone::sound_maps
