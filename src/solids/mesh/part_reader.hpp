#pragma once
// Makes the part of one rank from mesh files.

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "gmsh_mesh.hpp"
#include "idiophone/solids/mesh/meshes_in_parts.hpp"

namespace idiophone::mesh {

/// All functions are collective.
class PartReader {
 public:
  /// As read_part(); the arguments must outlive this object.
  PartReader(std::span<const scene::Body> bodies, const Outlines& outlines, std::span<const std::vector<Index>> coupled,
             MPI_Comm communicator);

  /// Call once. @throws as read_part()
  [[nodiscard]] ReadPart read();

 private:
  void take_elements();
  void take_nodes(std::size_t body);
  void take_surface(std::size_t body);
  void number_vertices();
  [[nodiscard]] Part build();
  /// From the numbers of this rank's meshes to those of all.
  void renumber(Part& part) const;
  [[nodiscard]] std::vector<Statistics> statistics_of(const Part& part) const;

  /// @param problem  of this rank, for text_of_problem(); empty for none
  void require_fit(std::size_t body, const std::string& problem) const;
  /// The outline, on rank 0; an empty mesh elsewhere.
  [[nodiscard]] const Mesh& outline(std::size_t body) const;
  /// The nodes of a body that this rank owns, as numbers in the body: first, and one past the last.
  [[nodiscard]] std::pair<Index, Index> owned(std::size_t body) const;
  /// The nodes of a coupled set that has an owned one; otherwise none.
  [[nodiscard]] std::span<const Index> needed(const std::vector<Index>& set) const;

  std::span<const scene::Body> bodies_;
  const Outlines& outlines_;
  std::span<const std::vector<Index>> coupled_;
  MPI_Comm communicator_;
  int rank_;
  std::vector<Index> first_;           ///< [ranks + 1] first node of each rank
  std::vector<GmshMesh> around_;       ///< [bodies] elements around this rank's nodes; tags are numbers in the body
  std::vector<Mesh> meshes_;           ///< [bodies] the meshes of `around_` when they are complete
  std::vector<Index> first_triangle_;  ///< [bodies] number in the body of the first triangle that this rank owns
  std::vector<Index> surface_nodes_;   ///< of all bodies, global numbers, ascending
  std::vector<Index> node_numbers_;    ///< [nodes of meshes_] global
};

}  // namespace idiophone::mesh
