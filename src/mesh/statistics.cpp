#include "idiophone/mesh/statistics.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "element_shape.hpp"

namespace idiophone::mesh {

Statistics statistics(const Mesh& mesh) {
  Statistics result;
  result.nodes = static_cast<Index>(mesh.nodes.size());
  result.elements = mesh.element_count();
  result.triangles = static_cast<Index>(mesh.surface.size());
  result.smallest_edge = std::numeric_limits<double>::infinity();
  result.worst_quality = std::numeric_limits<double>::infinity();
  for (Index number = 0; number < result.elements; ++number) {
    const ElementShape shape = shape_of(mesh, number);
    const auto lengths = edge_lengths(shape);
    result.smallest_edge = std::min(result.smallest_edge, std::ranges::min(lengths));
    result.largest_edge = std::max(result.largest_edge, std::ranges::max(lengths));
    result.volume += volume_of(shape);
    if (const double quality = quality_of(shape); quality < result.worst_quality) {
      result.worst_quality = quality;
      result.worst_element = number;
      result.worst_centre = centre_of(shape);
    }
  }
  for (const auto& [a, b, c] : mesh.surface) {
    const auto node = [&](Index number) -> const Vector3& { return mesh.nodes[number]; };
    result.surface_area += (node(b) - node(a)).cross(node(c) - node(a)).norm() / 2;
  }
  return result;
}

}  // namespace idiophone::mesh
