#pragma once
// What the kernels have to know of a body's elements and materials, as plain arrays.

#include <span>
#include <vector>

#include "idiophone/solids/mesh/part.hpp"
#include "idiophone/solids/solid/solid.hpp"
#include "solid_kernels.hpp"

namespace idiophone::accelerated {

/// Geometry at quadrature points. An element whose Jacobian is the same at all points has it once.
struct GeometryTable {
  std::vector<Index> first;    ///< [elements] as ElementEntry::geometry
  std::vector<double> values;  ///< 10 numbers each
};

/// @param reference  [local nodes] positions X, m. The elements are not inverted.
[[nodiscard]] GeometryTable geometry_table(const mesh::BodyPart& body, std::span<const Vector3> reference);

/// The elements of each node, ascending.
struct NodeElements {
  std::vector<Index> first;   ///< [nodes + 1] in `places`
  std::vector<Index> places;  ///< element times nodes of an element plus place of the node in it
};

/// @param nodes  [elements x nodes of an element]
/// @param count  of nodes from 0 on; elements of others are left out
[[nodiscard]] NodeElements node_elements(std::span<const Index> nodes, Index count);

[[nodiscard]] LawSize law_size(const solid::Solid& solid);

/// [regions x material_length()]
/// @param step  dt, s
[[nodiscard]] std::vector<double> material_table(const solid::Solid& solid, const LawSize& size, double step);

}  // namespace idiophone::accelerated
