#include "element_measures.hpp"

#include <algorithm>

#include "element_shape.hpp"
#include "idiophone/foundation/element/reference.hpp"

namespace idiophone::mesh {

namespace {

void add_edges(const ElementShape& shape, const Eigen::Matrix3d& axes, ElementMeasures& measures) {
  for (const auto& [i, j] : element::reference(shape.type).edges) {
    const Vector3 along = (axes.transpose() * (shape.nodes[j] - shape.nodes[i])).cwiseAbs();
    Eigen::Index main = 0;
    const double length = along.maxCoeff(&main);
    measures.edge_sums[main] += length;
    measures.edge_counts[main] += 1;
  }
}

}  // namespace

void ElementMeasures::add(const ElementMeasures& other) {
  elements += other.elements;
  smallest_edge = std::min(smallest_edge, other.smallest_edge);
  largest_edge = std::max(largest_edge, other.largest_edge);
  volume += other.volume;
  const bool has_worse = other.worst_quality < worst_quality;
  const bool is_equal = other.elements > 0 && other.worst_quality == worst_quality;
  if (has_worse || (is_equal && other.worst_element < worst_element)) {  // the first of equal ones on any ranks
    worst_quality = other.worst_quality;
    worst_element = other.worst_element;
    worst_centre = other.worst_centre;
  }
  edge_sums += other.edge_sums;
  edge_counts += other.edge_counts;
}

ElementMeasures measures_of(const Mesh& mesh, const Eigen::Matrix3d& axes, std::span<const char> counted) {
  ElementMeasures measures;
  for (Index number = 0; number < mesh.element_count(); ++number) {
    if (!counted.empty() && counted[number] == 0) {
      continue;
    }
    const ElementShape shape = shape_of(mesh, number);
    const auto lengths = edge_lengths(shape);
    ++measures.elements;
    measures.smallest_edge = std::min(measures.smallest_edge, std::ranges::min(lengths));
    measures.largest_edge = std::max(measures.largest_edge, std::ranges::max(lengths));
    measures.volume += volume_of(shape);
    if (const double quality = quality_of(shape); quality < measures.worst_quality) {
      measures.worst_quality = quality;
      measures.worst_element = number;
      measures.worst_centre = centre_of(shape);
    }
    add_edges(shape, axes, measures);
  }
  return measures;
}

}  // namespace idiophone::mesh
