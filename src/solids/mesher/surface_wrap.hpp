#pragma once
// Closed surfaces around damaged ones, by CGAL.

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace idiophone::mesher {

/// Triangles in space, in any unit of length.
struct Surface {
  std::vector<double> coordinates;     ///< [3 x vertices]
  std::vector<std::size_t> triangles;  ///< [3 x triangles] vertices, counted from 0
};

/// What the wrapped surface has to be like.
struct WrapLengths {
  double gap = 0.0;   ///< openings up to this width are closed
  double edge = 0.0;  ///< no edge of the result is shorter
};

/// A closed surface, facing outwards, that follows the outermost of the triangles. They can have openings, cross each
/// other, lie twice and face either way. It is an alpha wrap with an offset (Portaneri, Rouxel-Labbé, Hemmer,
/// Cohen-Steiner and Alliez 2022: "Alpha wrapping with an offset"), whose vertices then move by the offset to the
/// nearest points of the triangles. Its shortest edges are collapsed to points that keep the volume and the sharp edges
/// (Lindstrom and Turk 1998).
/// @return no triangles when there is no inside: the wrap passes through an opening wider than the gap
[[nodiscard]] Surface wrapped(const Surface& damaged, const WrapLengths& lengths);

/// A place where two triangles cross each other, or lie on each other; none: there is no such place.
[[nodiscard]] std::optional<std::array<double, 3>> crossing(const Surface& surface);

}  // namespace idiophone::mesher
