#include "idiophone/solids/mesh/statistics.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <functional>
#include <limits>

#include "element_shape.hpp"
#include "idiophone/foundation/dense/dense.hpp"
#include "idiophone/foundation/element/reference.hpp"

namespace idiophone::mesh {

namespace {

/// A box around the nodes.
struct OrientedBox {
  Eigen::Matrix3d axes;  ///< columns, unit vectors
  Vector3 extents;       ///< m
};

OrientedBox box_along(const Mesh& mesh, const Eigen::Matrix3d& axes) {
  Eigen::AlignedBox3d box;
  for (const Vector3& node : mesh.nodes) {
    box.extend(axes.transpose() * node);
  }
  return {axes, box.sizes()};
}

/// The smaller of the two boxes: the principal axes of a square or a cube are arbitrary.
OrientedBox smaller_box(const Mesh& mesh) {
  const OrientedBox principal = box_along(mesh, dense::principal_axes(mesh.nodes));
  const OrientedBox coordinate = box_along(mesh, Eigen::Matrix3d::Identity());
  return coordinate.extents.prod() <= principal.extents.prod() ? coordinate : principal;
}

/// The direction of an axis whose largest component is above 0.
Vector3 upward(const Vector3& axis) {
  Eigen::Index largest = 0;
  axis.cwiseAbs().maxCoeff(&largest);
  return axis[largest] < 0 ? Vector3(-axis) : axis;
}

/// Mean lengths along the axes of a box, of the edges that run mainly along each, m.
Vector3 mean_edges(const Mesh& mesh, const OrientedBox& box) {
  Vector3 sums = Vector3::Zero();
  Vector3 counts = Vector3::Zero();
  for (Index number = 0; number < mesh.element_count(); ++number) {
    const ElementShape shape = shape_of(mesh, number);
    for (const auto& [i, j] : element::reference(mesh.element).edges) {
      const Vector3 along = (box.axes.transpose() * (shape.nodes[j] - shape.nodes[i])).cwiseAbs();
      Eigen::Index main = 0;
      const double length = along.maxCoeff(&main);
      sums[main] += length;
      counts[main] += 1;
    }
  }
  return (counts.array() > 0).select(sums.array() / counts.array().max(1.0), box.extents.array());
}

}  // namespace

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
    const double volume = volume_of(shape);
    result.volume += volume;
    if (!mesh.regions.empty()) {
      result.volumes.resize(static_cast<std::size_t>(mesh.regions.back()) + 1);
      result.volumes[mesh.regions[number]] += volume;
    }
    if (const double quality = quality_of(shape); quality < result.worst_quality) {
      result.worst_quality = quality;
      result.worst_element = number;
      result.worst_centre = centre_of(shape);
    }
  }
  const OrientedBox box = smaller_box(mesh);
  const Vector3 edges = mean_edges(mesh, box);
  std::array<int, 3> order = {0, 1, 2};
  std::ranges::sort(order, std::greater{}, [&](int axis) { return box.extents[axis]; });
  for (int k = 0; k < 3; ++k) {
    result.extents[k] = box.extents[order[k]];
    result.axes.col(k) = upward(box.axes.col(order[k]));
    result.cells[k] = edges[order[k]];
  }
  for (const auto& [a, b, c] : mesh.outer_surface()) {
    const auto node = [&](Index number) -> const Vector3& { return mesh.nodes[number]; };
    result.surface_area += (node(b) - node(a)).cross(node(c) - node(a)).norm() / 2;
  }
  return result;
}

}  // namespace idiophone::mesh
