#pragma once
// The parameters of files other than .geo and .msh.

#include <optional>

#include "idiophone/solids/mesh/meshing.hpp"

namespace idiophone::mesher {

/// Metres for each unit of length of the file; 1 for a .geo file.
[[nodiscard]] double scale_of(const mesh::MeshingRequest& request);

/// The largest element, in the file's unit of length.
[[nodiscard]] std::optional<double> size_of(const mesh::MeshingRequest& request);

}  // namespace idiophone::mesher
