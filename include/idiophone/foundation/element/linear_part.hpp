#pragma once
// Functions of an element, as linear functions on the triangles of its faces.

#include <Eigen/Core>
#include <array>

#include "idiophone/foundation/element/reference.hpp"

namespace idiophone::element {

/// The linear function on a triangle of a face that is nearest to a function of the element, in the mean square over
/// the triangle. It has the same integral, and the same first moments.
/// @param corners  of the triangle, nodes of the face
/// @return [3 corners x nodes of the face] what the value at each node adds to those at the corners; rows add up to 1
[[nodiscard]] Eigen::Matrix3Xd linear_part(const ReferenceElement& reference, const Face& face,
                                           const std::array<int, 3>& corners);

}  // namespace idiophone::element
