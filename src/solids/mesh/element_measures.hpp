#pragma once
// What statistics need to know of elements, which may be on several ranks.

#include <limits>
#include <span>
#include <vector>

#include "idiophone/solids/mesh/statistics.hpp"

namespace idiophone::mesh {

/// A box around the nodes.
struct Box {
  Eigen::Matrix3d axes;  ///< columns, unit vectors
  Vector3 extents;       ///< m
};

/// Along the principal axes or along x, y, z, the smaller one: the principal axes of a square or a cube are arbitrary.
[[nodiscard]] Box box_of(const Mesh& mesh);

/// Of some elements; names as in Statistics.
struct ElementMeasures {
  Index elements = 0;
  double smallest_edge = std::numeric_limits<double>::infinity();
  double largest_edge = 0.0;
  double volume = 0.0;
  double worst_quality = std::numeric_limits<double>::infinity();
  Index worst_element = 0;
  Vector3 worst_centre = Vector3::Zero();
  Vector3 edge_sums = Vector3::Zero();    ///< lengths along the axes of the edges that run mainly along each, m
  Vector3 edge_counts = Vector3::Zero();  ///< how many edges these are

  /// Takes in those of other elements, whose numbers count from the same first one.
  void add(const ElementMeasures& other);
};

/// @param axes     of the box, in the columns
/// @param counted  [elements] 1 for those that count; empty: all
[[nodiscard]] ElementMeasures measures_of(const Mesh& mesh, const Eigen::Matrix3d& axes,
                                          std::span<const char> counted = {});

/// [regions] Volumes of the material regions, m3.
/// @param counted  [elements] 1 for those that count; empty: all
[[nodiscard]] std::vector<double> region_volumes(const Mesh& mesh, std::size_t regions,
                                                 std::span<const char> counted = {});

/// Without the volumes of regions.
/// @param outline  of the mesh, which may lack its elements
[[nodiscard]] Statistics statistics(const Mesh& outline, const Box& box, const ElementMeasures& measures);

}  // namespace idiophone::mesh
