#pragma once
// Surfaces of triangles, as STL and OBJ files hold them, and the volumes within closed ones.

#include <cstddef>
#include <string>
#include <vector>

namespace idiophone::mesher {

/// Makes one surface of the present model out of triangles.
/// @param coordinates  [3 x vertices]
/// @param triangles    [3 x triangles] vertices, counted from 1
void add_triangles(const std::vector<double>& coordinates, const std::vector<std::size_t>& triangles);

/// Reads the faces of a Wavefront OBJ file into the present model, as one surface. Polygons become triangles; normals,
/// textures, materials and lines are left out.
/// @param object  name of the object (`o`) or group (`g`) whose faces are read; empty: all
/// @throws Refusal, with the line, when the file says something else; NoSuchObject
void open_obj(const std::string& file, const std::string& object);

/// Reads the triangles of a glTF, PLY or FBX file into the present model, as one surface in metres. Vertices at one
/// place become one.
/// @param object  name of the node or mesh, which stands for its descendants, too; empty: the only one
/// @throws Refusal when the file can't be read; NoSuchObject
void open_model(const std::string& file, const std::string& object);

/// Makes the volume that the present model's triangles enclose. Facets that meet at less than 40 degrees become one
/// smooth surface, which is to be meshed anew.
/// @throws std::runtime_error when the surface isn't closed; what gmsh throws
void enclose_triangles();

/// Makes the volume that the present model's triangles enclose. They stay as they are. Those that meet at less than 40
/// degrees become one surface.
void fill_triangles();

/// Makes smooth surfaces of the present model's triangles, open or closed.
/// @throws std::runtime_error when more than two triangles share an edge; what gmsh throws
void smooth_triangles();

}  // namespace idiophone::mesher
