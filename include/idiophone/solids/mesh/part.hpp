#pragma once
// What one rank holds of all bodies. METIS partitions the nodes; everything else follows a node: a rank computes every
// element that touches a node it owns (so no force has to be sent back), and owns the elements and surface triangles
// whose lowest-numbered node it owns (so each is counted once).
//
// Global numbers of nodes, elements and triangles run over all bodies: body 0's first, then body 1's, ...

#include <mpi.h>

#include <span>
#include <vector>

#include "idiophone/foundation/element/type.hpp"
#include "idiophone/solids/mesh/mesh.hpp"

namespace idiophone::mesh {

/// One body's share on this rank. All node numbers are local (see Part).
struct BodyPart {
  element::Type element = element::tet10;
  Index owned_begin = 0;  ///< this body's owned nodes are the local numbers [owned_begin, owned_end)
  Index owned_end = 0;
  Index first_element = 0;         ///< global number of this body's first element
  Index global_elements = 0;       ///< of this body, over all ranks
  std::vector<Index> element_ids;  ///< global numbers of the elements computed here, ascending
  std::vector<Index> elements;     ///< [nodes per element x elements computed here] local node numbers
  std::vector<char> owned;         ///< [elements computed here] 1 where this rank owns the element
  std::vector<Index> regions;      ///< [elements computed here] as Mesh::regions

  /// Node numbers of an element computed here, [nodes per element].
  /// @param place  in element_ids
  [[nodiscard]] std::span<const Index> element_nodes(std::size_t place) const {
    const std::size_t width = element::node_count(element);
    return std::span(elements).subspan(place * width, width);
  }

  /// The material region of an element computed here.
  /// @param place  in element_ids
  [[nodiscard]] Index region(std::size_t place) const { return regions.empty() ? 0 : regions[place]; }
};

/// One rank's share of all bodies. Local nodes: the owned ones by ascending global number, then the ghosts likewise.
struct Part {
  Index global_nodes = 0;      ///< over all ranks and bodies
  Index global_elements = 0;   ///< likewise
  Index global_triangles = 0;  ///< likewise
  Index global_vertices = 0;   ///< surface nodes, likewise

  Index owned_nodes = 0;
  std::vector<Index> node_ids;     ///< [local nodes] global numbers
  std::vector<Vector3> reference;  ///< [local nodes] reference positions, m
  std::vector<int> ghost_rank;     ///< [ghosts] the rank that owns it
  std::vector<Index> ghost_index;  ///< [ghosts] its local number there
  std::vector<BodyPart> bodies;    ///< [bodies], also where a body has nothing here

  std::vector<Triangle> surface;     ///< owned exterior triangles, as places in `vertices`, ascending global number
  std::vector<Index> triangle_ids;   ///< [surface] global numbers
  std::vector<Index> triangle_body;  ///< [surface] which body
  std::vector<Index> vertices;       ///< the surface's nodes: local node numbers, ascending by global number
  std::vector<Index> vertex_ids;  ///< [vertices] global numbers among all surface nodes; a vertex on two ranks' borders
                                  ///< stands on both with the same number

  std::vector<Index> first_piece;  ///< [bodies + 1] the first of the pieces that each body can fall apart into,
                                   ///< numbered over all bodies (Mesh::pieces)
  std::vector<Index> pieces;       ///< [local nodes] the piece that a node belongs to; -1 where its body stays in one.
                                   ///< Empty where all bodies do

  /// Into how many pieces a body can fall apart; 0 where it stays in one.
  [[nodiscard]] Index piece_count(std::size_t body) const { return first_piece[body + 1] - first_piece[body]; }
};

/// First global node, element and triangle of each body, and one past the last: [bodies + 1].
struct Offsets {
  std::vector<Index> nodes, elements, triangles;
};
[[nodiscard]] Offsets offsets(const std::vector<Mesh>& meshes);
/// Of meshes that may lack their elements.
/// @param elements  [bodies] how many they have
[[nodiscard]] Offsets offsets_of(const std::vector<Mesh>& meshes, std::span<const Index> elements);

/// Partitions the bodies' nodes with METIS on rank 0 and sends every rank its own. Collective.
/// The same meshes and rank count give the same parts. No rank gets an empty part.
/// @param meshes   on rank 0, all bodies' meshes; ignored elsewhere
/// @param coupled  on rank 0, sets of global node numbers: a rank that owns a node of a set has the others as ghosts
/// @throws std::runtime_error, on every rank, when there are more ranks than elements can fill (the message says how
///         many ranks would do).
[[nodiscard]] Part distribute(const std::vector<Mesh>& meshes, MPI_Comm communicator,
                              std::span<const std::vector<Index>> coupled = {});

}  // namespace idiophone::mesh
