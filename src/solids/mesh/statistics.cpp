#include "idiophone/solids/mesh/statistics.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <functional>

#include "element_measures.hpp"
#include "element_shape.hpp"
#include "idiophone/foundation/dense/dense.hpp"

namespace idiophone::mesh {

namespace {

Box box_along(const Mesh& mesh, const Eigen::Matrix3d& axes) {
  Eigen::AlignedBox3d box;
  for (const Vector3& node : mesh.nodes) {
    box.extend(axes.transpose() * node);
  }
  return {axes, box.sizes()};
}

/// The direction of an axis whose largest component is above 0.
Vector3 upward(const Vector3& axis) {
  Eigen::Index largest = 0;
  axis.cwiseAbs().maxCoeff(&largest);
  return axis[largest] < 0 ? Vector3(-axis) : axis;
}

Vector3 mean_edges(const ElementMeasures& measures, const Vector3& extents) {
  const auto counts = measures.edge_counts.array();
  return (counts > 0).select(measures.edge_sums.array() / counts.max(1.0), extents.array());
}

}  // namespace

Box box_of(const Mesh& mesh) {
  const Box principal = box_along(mesh, dense::principal_axes(mesh.nodes));
  const Box coordinate = box_along(mesh, Eigen::Matrix3d::Identity());
  return coordinate.extents.prod() <= principal.extents.prod() ? coordinate : principal;
}

Statistics statistics(const Mesh& outline, const Box& box, const ElementMeasures& measures) {
  Statistics result;
  result.nodes = static_cast<Index>(outline.nodes.size());
  result.elements = measures.elements;
  result.triangles = static_cast<Index>(outline.surface.size());
  result.smallest_edge = measures.smallest_edge;
  result.largest_edge = measures.largest_edge;
  result.volume = measures.volume;
  result.worst_quality = measures.worst_quality;
  result.worst_element = measures.worst_element;
  result.worst_centre = measures.worst_centre;
  const Vector3 edges = mean_edges(measures, box.extents);
  std::array<int, 3> order = {0, 1, 2};
  std::ranges::sort(order, std::greater{}, [&](int axis) { return box.extents[axis]; });
  for (int k = 0; k < 3; ++k) {
    result.extents[k] = box.extents[order[k]];
    result.axes.col(k) = upward(box.axes.col(order[k]));
    result.cells[k] = edges[order[k]];
  }
  for (const auto& [a, b, c] : outline.outer_surface()) {
    const auto node = [&](Index number) -> const Vector3& { return outline.nodes[number]; };
    result.surface_area += (node(b) - node(a)).cross(node(c) - node(a)).norm() / 2;
  }
  return result;
}

std::vector<double> region_volumes(const Mesh& mesh, std::size_t regions, std::span<const char> counted) {
  std::vector<double> volumes(regions);
  for (std::size_t number = 0; number < mesh.regions.size(); ++number) {
    if (counted.empty() || counted[number] != 0) {
      volumes[mesh.regions[number]] += volume_of(shape_of(mesh, static_cast<Index>(number)));
    }
  }
  return volumes;
}

Statistics statistics(const Mesh& mesh) {
  const Box box = box_of(mesh);
  Statistics result = statistics(mesh, box, measures_of(mesh, box.axes));
  const Index regions = mesh.regions.empty() ? 0 : mesh.regions.back() + 1;
  result.volumes = region_volumes(mesh, static_cast<std::size_t>(regions));
  return result;
}

}  // namespace idiophone::mesh
