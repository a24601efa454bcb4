#pragma once
// Statistics of a mesh, as `check` prints them.

#include "idiophone/solids/mesh/mesh.hpp"

namespace idiophone::mesh {

/// Size and shape of a mesh.
struct Statistics {
  Index nodes = 0;
  Index elements = 0;
  Index triangles = 0;                ///< of the surface
  double smallest_edge = 0.0;         ///< between corners, m
  double largest_edge = 0.0;          ///< between corners, m
  double volume = 0.0;                ///< by the elements' quadrature, m3
  std::vector<double> volumes;        ///< of the material regions, m3; empty where there is one material
  double surface_area = 0.0;          ///< m2
  Vector3 extents = Vector3::Zero();  ///< of the body along its principal axes, or along x, y, z if that box is
                                      ///< smaller; descending, m
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< these axes in the columns, in the order of the extents: unit
                                                       ///< vectors whose largest component is above 0
  Vector3 cells = Vector3::Zero();  ///< mean length along these axes of the edges that run mainly along each, m
  double worst_quality = 0.0;       ///< 1 for a regular tetrahedron, towards 0 for a sliver: 6 sqrt(2) V / l_rms^3
                               ///< (Parthasarathy, Graichen, Hathaway 1994), V from the smallest Jacobian in a tet10
  Index worst_element = 0;                 ///< the number of an element of that quality
  Vector3 worst_centre = Vector3::Zero();  ///< its centre, m
};

[[nodiscard]] Statistics statistics(const Mesh& mesh);

}  // namespace idiophone::mesh
