#pragma once
// Whether polygons and circles bound a region.

#include "idiophone/foundation/deck/mistakes.hpp"
#include "idiophone/solids/mesh/plane_region.hpp"

namespace idiophone::sound_maps {

/// Reports the first two corners at one place, or else the first two edges that cross, touch, or run back over each
/// other. Places are the same where they are closer than a millionth of the polygon's extent.
/// @param node     list of the corners in the deck
/// @param polygon  its corners, as many, at least 3, m
/// @return whether the polygon is simple
bool check_polygon(const deck::Node& node, const std::vector<mesh::Point2>& polygon, deck::Mistakes& mistakes);

/// Reports the first hole that reaches the outline or is outside of it, or else the first two holes that meet.
/// @param node    list of the holes in the deck
/// @param region  its polygons are simple
bool check_holes(const deck::Node& node, const mesh::PlaneRegion& region, deck::Mistakes& mistakes);

}  // namespace idiophone::sound_maps
