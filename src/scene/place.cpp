#include "idiophone/scene/ranges.hpp"
#include "idiophone/scene/sections.hpp"

namespace idiophone::scene {

bool read_place(Section& section, PatchPlace& place) {
  if (const Node* at = section.find("at")) {
    place.where = at->where;
  }
  const bool has_point = section.required("at", place.at, coordinate);
  return section.optional("radius", place.radius, Range{.at_least = 0.0, .at_most = coordinate.at_most, .unit = "m"}) &&
         has_point;
}

}  // namespace idiophone::scene
