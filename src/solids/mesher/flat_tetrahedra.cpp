#include "flat_tetrahedra.hpp"

#include <gmsh.h>

#include <Eigen/Core>
#include <cmath>

namespace idiophone::mesher {

namespace {

constexpr double least_determinant = 1e-6;  // of the product of the lengths of three edges

bool has_flat_tetrahedra() {
  constexpr int tetrahedron = 4;  // gmsh's number of the type
  std::vector<double> jacobians, determinants, places;
  gmsh::model::mesh::getJacobians(tetrahedron, {0.25, 0.25, 0.25}, jacobians, determinants, places);
  for (std::size_t i = 0; i < determinants.size(); ++i) {
    const Eigen::Map<const Eigen::Matrix3d> edges(&jacobians[9 * i]);
    if (std::abs(determinants[i]) < least_determinant * edges.colwise().norm().prod()) {
      return true;
    }
  }
  return false;
}

}  // namespace

std::vector<std::string> mend_flat_tetrahedra(bool keeps_surface) {
  if (!has_flat_tetrahedra()) {
    return {};
  }
  gmsh::vectorpair volumes;
  gmsh::model::getEntities(volumes, 3);
  gmsh::model::mesh::clear(keeps_surface ? volumes : gmsh::vectorpair());  // no list stands for everything
  gmsh::option::setNumber("Mesh.Algorithm3D", 1);
  gmsh::model::mesh::generate(3);
  return {"Delaunay filled the volume, because HXT left flat tetrahedra"};
}

}  // namespace idiophone::mesher
