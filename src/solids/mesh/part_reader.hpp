#pragma once
// Makes the parts of one process's ranks from mesh files.

#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "gmsh_mesh.hpp"
#include "idiophone/solids/mesh/meshes_in_parts.hpp"
#include "part_numbers.hpp"

namespace idiophone::mesh {

/// All functions are collective. Call one of the public ones, once.
class PartReader {
 public:
  /// As for_each_part_in_rows(); the arguments must outlive this object.
  PartReader(std::span<const scene::Body> bodies, const std::vector<Mesh>& outlines, const Offsets& offsets,
             std::vector<ElementRows>& rows, std::span<const std::vector<Index>> coupled, MPI_Comm communicator);

  /// The part of this process, which is a rank. @throws as read_part()
  [[nodiscard]] ReadPart read();

  /// The parts of this process's ranks. @throws as for_each_part_in_rows()
  void for_each_part(int ranks, const std::function<void(const Part&)>& visit);

 private:
  /// @param ranks  that share the bodies
  void take_elements(int ranks);
  void take_nodes(std::size_t body);
  void take_surface(std::size_t body);
  void check(std::size_t body) const;
  void number_vertices();
  /// Calls visit(part) with the part of each of this process's ranks, which visit() may take.
  void build(const std::function<void(Part&)>& visit);

  /// The outline, on rank 0; an empty mesh elsewhere.
  [[nodiscard]] const Mesh& outline(std::size_t body) const;
  /// The range of a body's nodes that is this process's, as numbers in the body: first, and one past the last.
  [[nodiscard]] std::pair<Index, Index> range(std::size_t body) const;
  /// Nodes in this range that other processes have, likewise.
  [[nodiscard]] std::vector<Index> away(std::size_t body) const;
  /// The nodes of a coupled set that has an owned one; otherwise none.
  [[nodiscard]] std::span<const Index> needed(const std::vector<Index>& set) const;

  std::span<const scene::Body> bodies_;
  const std::vector<Mesh>& outlines_;
  std::vector<ElementRows>& rows_;
  std::span<const std::vector<Index>> coupled_;
  MPI_Comm communicator_;
  int process_;  ///< its number
  std::optional<NodeDivision> division_;
  PartNumbers numbers_;
  std::vector<GmshMesh> around_;  ///< [bodies] elements around this process's nodes; tags are numbers in the body
  std::vector<Mesh> meshes_;      ///< [bodies] the meshes of `around_` when they are complete
};

}  // namespace idiophone::mesh
