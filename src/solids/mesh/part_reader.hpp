#pragma once
// Makes the part of one rank from mesh files.

#include <span>
#include <utility>
#include <vector>

#include "gmsh_mesh.hpp"
#include "idiophone/solids/mesh/meshes_in_parts.hpp"
#include "part_numbers.hpp"

namespace idiophone::mesh {

/// All functions are collective.
class PartReader {
 public:
  /// As read_part(); the arguments must outlive this object.
  PartReader(std::span<const scene::Body> bodies, MeshShares& shares, std::span<const std::vector<Index>> coupled,
             MPI_Comm communicator);

  /// Call once. @throws as read_part()
  [[nodiscard]] ReadPart read();

 private:
  void take_elements();
  void take_nodes(std::size_t body);
  void take_surface(std::size_t body);
  void check(std::size_t body) const;
  void number_vertices();
  [[nodiscard]] Part build();

  /// The outline, on rank 0; an empty mesh elsewhere.
  [[nodiscard]] const Mesh& outline(std::size_t body) const;
  /// The nodes of a body that this rank owns, as numbers in the body: first, and one past the last.
  [[nodiscard]] std::pair<Index, Index> owned(std::size_t body) const;
  /// The nodes of a coupled set that has an owned one; otherwise none.
  [[nodiscard]] std::span<const Index> needed(const std::vector<Index>& set) const;

  std::span<const scene::Body> bodies_;
  MeshShares& shares_;
  std::span<const std::vector<Index>> coupled_;
  MPI_Comm communicator_;
  int rank_;
  PartNumbers numbers_;
  std::vector<GmshMesh> around_;  ///< [bodies] elements around this rank's nodes; node tags are numbers in the body
  std::vector<Mesh> meshes_;      ///< [bodies] the meshes of `around_` when they are complete
};

}  // namespace idiophone::mesh
