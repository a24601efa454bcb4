#pragma once
// From a geometry file to elements, in gmsh's own numbering.

#include "geo_parameters.hpp"

namespace idiophone::mesher {

/// Opens the file in gmsh's initial state, meshes it where it is a geometry, and brings the mesh to the order that is
/// asked for.
/// @throws what gmsh throws (std::string)
[[nodiscard]] mesh::MeshingAnswer make_mesh(const mesh::MeshingRequest& request, const GeoScripts& scripts);

}  // namespace idiophone::mesher
