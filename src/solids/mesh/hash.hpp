#pragma once
// The fingerprint by which a checkpoint knows its mesh.

#include "idiophone/solids/mesh/mesh.hpp"

namespace idiophone::mesh {

/// What Mesh::hash holds: FNV-1a of 64 bits over the element type, the bits of the nodes, elements, surface and groups.
[[nodiscard]] std::string hash_of(const Mesh& mesh);

}  // namespace idiophone::mesh
