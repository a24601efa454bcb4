#pragma once
// A cell of a contact's partner where it is now, as overlaps need it.

#include <array>
#include <span>

#include "overlap.hpp"
#include "side.hpp"

namespace idiophone::contact {

class SideCell {
 public:
  SideCell(const Side& side, Index number)
      : number_(number),
        tetrahedron_(side.tetrahedron(number)),
        planes_{tetrahedron_.plane(0), tetrahedron_.plane(1), tetrahedron_.plane(2), tetrahedron_.plane(3)},
        exterior_(side.skin.exterior[number]) {}

  /// Valid as long as this object.
  [[nodiscard]] Cell view() const { return {number_, &tetrahedron_, planes_, exterior_}; }

 private:
  Index number_;
  Tetrahedron tetrahedron_;
  std::array<Plane, 4> planes_;
  std::span<const char> exterior_;
};

/// A convex part of a shape. Valid as long as the shape.
[[nodiscard]] inline Cell part_of(const RigidShape& shape, Index part) {
  const Index first = shape.first_plane[part];
  const Index count = shape.first_plane[part + 1] - first;
  return {part, nullptr, std::span(shape.planes).subspan(first, count),
          std::span(shape.exterior).subspan(first, count)};
}

}  // namespace idiophone::contact
