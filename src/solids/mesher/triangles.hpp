#pragma once
// Surfaces of triangles, as STL and OBJ files hold them, and the volumes within closed ones.

#include <string>

namespace idiophone::mesher {

/// Reads the faces of a Wavefront OBJ file into the present model, as one surface. Polygons become triangles; normals,
/// textures, materials and lines are left out.
/// @throws std::runtime_error, with the line, when the file says something else
void open_obj(const std::string& file);

/// Makes the volume that the present model's triangles enclose. Facets that meet at less than 40 degrees become one
/// smooth surface, which is to be meshed anew.
/// @throws std::runtime_error when the surface isn't closed; what gmsh throws
void enclose_triangles();

/// Makes smooth surfaces of the present model's triangles, open or closed.
/// @throws std::runtime_error when more than two triangles share an edge; what gmsh throws
void smooth_triangles();

}  // namespace idiophone::mesher
