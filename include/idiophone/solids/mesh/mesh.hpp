#pragma once
// The whole mesh of one body, as rank 0 holds it: read through gmsh, checked, and numbered along a space-filling curve.

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "idiophone/foundation/element/type.hpp"
#include "idiophone/foundation/types.hpp"
#include "idiophone/scene/body.hpp"

namespace idiophone::mesh {

/// Three nodes in the order that makes the normal of eq. 4 point out of the body.
using Triangle = std::array<Index, 3>;

/// A face of two elements on a surface along which the body breaks. Both have nodes of their own there, except where
/// the surface ends inside the body.
struct FractureFace {
  std::size_t surface = 0;    ///< its place in scene::Body::fracture
  std::size_t corners = 3;    ///< 4 of a quadrilateral
  std::size_t triangles = 0;  ///< in Mesh::surface, of both sides
  /// Corners, then the other nodes, of either side. Nodes at one place of the lists are in one place in space. The
  /// corners' order makes the normal point out of side 0 into side 1.
  std::array<std::vector<Index>, 2> nodes;
  std::vector<double> shares;  ///< [nodes of a side] of the force of a constant stress on the face; they add up to 1
};

/// Triangles of both sides of all faces.
[[nodiscard]] std::size_t triangle_count(std::span<const FractureFace> faces);

/// One body's elements. Node and element numbers run along the same space-filling curve, so neighbours are near in
/// memory and the numbers do not depend on any partition. Elements are numbered region by region.
struct Mesh {
  element::Type element = element::tet10;
  std::vector<Vector3> nodes;   ///< [nodes] reference positions, m
  std::vector<Index> elements;  ///< [nodes per element x elements] node numbers, ordered as element::ReferenceElement
  /// [elements] The place in scene::Body::regions of the one that an element lies in, ascending. Empty where the body
  /// has one material.
  std::vector<Index> regions;
  /// Exterior triangles; a tet10 face is four of them (docs/method/theory.md, The surface). They are sorted by smallest
  /// node, then by their other nodes, so their order is a property of the mesh. Those of
  /// `fracture_faces` follow, in their order: those of side 0, then those of side 1.
  std::vector<Triangle> surface;
  std::vector<FractureFace> fracture_faces;          ///< of a divided body
  std::map<std::string, std::vector<Index>> groups;  ///< physical group -> its nodes, ascending
  bool indivisible = false;                          ///< one rank has all of it: a modal body
  std::optional<std::size_t> beside;  ///< of an indivisible body: the rank of that body has it, too, an earlier one
  std::string hash;  ///< 16 hexadecimal digits of nodes, elements and groups: two meshes with one hash are the same
  std::vector<std::string> notes;  ///< for the user: what was done to the shape of the file
  /// Of linear tetrahedra: physical group of surfaces -> its triangles. Other elements have nodes inside their faces or
  /// edges, which tell the faces of a group from others.
  std::map<std::string, std::vector<Triangle>> group_triangles;
  /// [nodes] Of a divided body: the piece that a node belongs to when all fracture faces are broken, from 0 in the
  /// order of the pieces' first nodes. Empty where there is only one.
  std::vector<Index> pieces;

  [[nodiscard]] Index element_count() const {
    return static_cast<Index>(elements.size()) / element::node_count(element);
  }
  /// Into how many pieces the body can fall apart; 0 where it stays in one.
  [[nodiscard]] Index piece_count() const { return pieces.empty() ? 0 : std::ranges::max(pieces) + 1; }
  /// The surface of the whole body, without fracture faces.
  [[nodiscard]] std::span<const Triangle> outer_surface() const {
    return std::span(surface).first(surface.size() - triangle_count(fracture_faces));
  }
  /// Node numbers of one element, [nodes per element].
  [[nodiscard]] std::span<const Index> element_nodes(Index number) const {
    const std::size_t width = element::node_count(element);
    return std::span(elements).subspan(number * width, width);
  }
};

/// Reads or makes the mesh of a body with gmsh, makes it first or second order as the body asks, checks it, orders it.
/// Call on one rank only.
/// @throws deck::DeckError, pointing at the body's mesh key, when the file can't be read or meshed, has no tetrahedra,
///         has inverted or degenerate elements (their numbers and centres are listed), has nodes no element uses in a
///         group, falls into disconnected parts (counted, with an element of each), or a parameter isn't one of the
///         .geo file's; pointing at a material region, when the mesh has no such group of elements, an element is in
///         two regions, or in none.
[[nodiscard]] Mesh read_mesh(const scene::Body& body);

/// The mesh of each body. Bodies of the same shape are meshed once.
/// @throws deck::DeckError as read_mesh() does
[[nodiscard]] std::vector<Mesh> read_meshes(std::span<const scene::Body> bodies);

/// The mesh of a body that can break: each node on its fracture surfaces becomes one node for each part of the body
/// that the surfaces separate around it. Groups have all of them. Call on one rank only.
/// @param mesh  as read_mesh() gives it
/// @throws deck::DeckError, pointing at the fracture surface, when the mesh has no such group, or it has no faces
/// inside
///         the body, lies on the outside of the body, shares faces with another one, divides nothing, or is so coarse
///         that no traction is known on a face between crossings.
[[nodiscard]] Mesh divide(const Mesh& mesh, const scene::Body& body);

/// The surface that belongs to each node: a third of each triangle's area is its corner's. [nodes] m2
/// @param triangles  as places in `nodes`
/// @param nodes      positions, m
[[nodiscard]] std::vector<double> nodal_areas(std::span<const Triangle> triangles, std::span<const Vector3> nodes);

/// Nodes of a patch with the share of the whole that each carries; shares add up to 1.
struct Patch {
  std::vector<Index> nodes;    ///< ascending
  std::vector<double> shares;  ///< [nodes]
};

/// The patch at a place on the surface. Radius 0: the point's linear weights in the surface triangle that it lies in.
/// Otherwise: every surface node within the radius, weighted by its share of the surrounding triangles' area.
/// @throws deck::DeckError, pointing at the place, when the point is farther from the surface than a tenth of the
///         nearest triangle's longest edge (and says the nearest point), or when the patch holds no node.
[[nodiscard]] Patch find_patch(const Mesh& mesh, const scene::PatchPlace& place);

/// Nodes of a physical group.
/// @throws deck::DeckError, pointing at `where`, with the mesh's groups and the nearest name, when there is none.
[[nodiscard]] const std::vector<Index>& find_group(const Mesh& mesh, const std::string& group,
                                                   const deck::Location& where);

}  // namespace idiophone::mesh
