#pragma once
// What the edges of a plate hold, and the rigid motions that they leave.

#include <Eigen/Core>
#include <vector>

#include "idiophone/solids/eigenmodes/plate.hpp"

namespace idiophone::eigenmodes {

/// The unknowns of a plate: three for each node of its mesh. At a corner of a triangle they are the deflection and its
/// derivatives along the tangent and along the left normal of the tangent; at the middle of an edge the first one is
/// the derivative across the edge, and the others are not used.
struct PlateUnknowns {
  std::vector<Eigen::Vector2d> places;    ///< [nodes] of corners, m
  std::vector<Eigen::Vector2d> tangents;  ///< [nodes] at corners; unit normals of edges at their middles
  std::vector<bool> is_corner;            ///< [nodes]
  std::vector<bool> held;                 ///< [3 x nodes] also those that are not used
};

[[nodiscard]] PlateUnknowns plate_unknowns(const mesh::PlaneRegion& region, const mesh::PlaneMesh& mesh,
                                           const Plate& plate);

/// Independent fields [3 x nodes] of the motions without strain that nothing holds: none to three.
[[nodiscard]] std::vector<std::vector<double>> rigid_plate_motions(const PlateUnknowns& unknowns);

}  // namespace idiophone::eigenmodes
