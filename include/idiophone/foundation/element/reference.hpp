#pragma once
// The table of reference elements: all that other modules ask about an element type. Coordinates xi are those of the
// reference element and have no unit.

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "idiophone/foundation/element/type.hpp"
#include "idiophone/foundation/types.hpp"

namespace idiophone::element {

struct QuadraturePoint {
  Vector3 place;              ///< xi
  double weight = 0.0;        ///< the weights add up to the reference element's volume
  Eigen::MatrixX3d gradient;  ///< [nodes x 3] shape_gradients at the place
};

/// Numbers are places among the element's nodes.
struct Face {
  std::vector<int> corners;                   ///< 3, or 4 of a quadrilateral; counter-clockwise as seen from outside
  std::vector<int> nodes;                     ///< all that lie on the face, its corners first
  std::vector<std::array<int, 3>> triangles;  ///< straight triangles that cover it, counter-clockwise likewise
};

/// How gmsh calls and numbers an element. Its hexahedra have the same order in all directions, and evenly spaced nodes.
struct GmshElement {
  std::string family;      ///< as gmsh::model::mesh::getElementType takes it
  int order = 1;           ///< polynomial order
  std::vector<int> nodes;  ///< [nodes] gmsh's place of each of our nodes; empty for a hexahedron of two orders
};

/// How ParaView draws an element, by XDMF in VTK's numbering: as one cell, or cut into several of one type.
struct DrawnElement {
  std::string topology;                 ///< XDMF's TopologyType
  int vtk_cell = 0;                     ///< VTK's number of this cell type
  std::vector<std::vector<int>> cells;  ///< [cells][nodes of a cell] our node at each of VTK's places
  /// [faces][triangles] Straight triangles that cover each face of a cell, counter-clockwise as seen from outside;
  /// places in the cell
  std::vector<std::vector<std::array<int, 3>>> faces;

  [[nodiscard]] int nodes_per_cell() const { return static_cast<int>(cells.front().size()); }
};

/// One row of the table. Numbers of nodes are places among the element's nodes.
struct ReferenceElement {
  Type type;
  std::vector<Vector3> nodes;                           ///< [nodes] xi of each node
  std::vector<int> corners;                             ///< the nodes that are corners
  std::vector<std::array<int, 2>> edges;                ///< the corners at the ends of each edge
  std::vector<Face> faces;                              ///< their corners' order makes all of them face outward
  std::vector<std::array<int, 4>> straight_tetrahedra;  ///< that fill the element, of positive volume
  std::vector<QuadraturePoint> quadrature;              ///< of the internal force
  std::vector<Eigen::MatrixX3d> corner_gradients;       ///< [corners][nodes x 3] shape_gradients at the corners
  double regular_jacobian = 0.0;  ///< Jacobian determinant of the regular element with edges of length 1
  GmshElement gmsh;
  DrawnElement drawn;
};

/// The row of a type. The reference stays valid.
[[nodiscard]] const ReferenceElement& reference(Type type);

/// An element that is drawn with cells of so many nodes: all such have the same topology and faces.
/// @throws std::runtime_error if there is none
[[nodiscard]] const DrawnElement& drawn_with(int nodes_per_cell);

/// gmsh's place of each node of a quadrilateral with evenly spaced nodes. Node (i, j), counted along its first and
/// second direction, is number i + (order + 1) j.
[[nodiscard]] std::vector<int> gmsh_quadrilateral_nodes(int order);

/// N_a at any point. [nodes]
[[nodiscard]] Eigen::VectorXd shape_functions(Type type, const Vector3& xi);

/// dN_a/dxi_k at any point. [nodes x 3]
[[nodiscard]] Eigen::MatrixX3d shape_gradients(Type type, const Vector3& xi);

}  // namespace idiophone::element
