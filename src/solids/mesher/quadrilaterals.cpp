#include "quadrilaterals.hpp"

#include <gmsh.h>

#include <algorithm>
#include <vector>

namespace idiophone::mesher {

namespace {

bool triangles_remain() {
  constexpr int triangle = 2;  // gmsh's number of the type
  std::vector<int> types;
  gmsh::model::mesh::getElementTypes(types, 2);
  return std::ranges::find(types, triangle) != types.end();
}

}  // namespace

void mesh_with_quadrilaterals() {
  gmsh::option::setNumber("Mesh.RecombineAll", 1);
  gmsh::model::mesh::generate(2);
  if (!triangles_remain()) {
    return;
  }
  double factor = 1.0;
  gmsh::option::getNumber("Mesh.MeshSizeFactor", factor);
  gmsh::option::setNumber("Mesh.MeshSizeFactor", 2 * factor);
  gmsh::option::setNumber("Mesh.SubdivisionAlgorithm", 0);  // only refine() is to divide
  gmsh::model::mesh::clear();
  gmsh::model::mesh::generate(2);
  gmsh::option::setNumber("Mesh.SubdivisionAlgorithm", 1);
  gmsh::model::mesh::refine();
}

}  // namespace idiophone::mesher
