#pragma once
// The numbering of a mesh along the space-filling curve.

#include "idiophone/solids/mesh/mesh.hpp"

namespace idiophone::mesh {

/// The same mesh with nodes and elements numbered along the curve, without hash and notes. Nodes in one place keep
/// their order.
[[nodiscard]] Mesh ordered(const Mesh& mesh);

}  // namespace idiophone::mesh
