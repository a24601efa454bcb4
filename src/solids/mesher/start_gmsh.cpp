#include "start_gmsh.hpp"

#include <gmsh.h>

namespace idiophone::mesher {

void start_gmsh() {
  gmsh::initialize(0, nullptr, false);
  gmsh::option::setNumber("General.NumThreads", 1);
  gmsh::option::setNumber("Mesh.Algorithm3D", 10);
  gmsh::option::setString("Geometry.OCCTargetUnit", "M");
}

void clear_gmsh() {
  gmsh::clear();
  gmsh::onelab::clear();
}

}  // namespace idiophone::mesher
