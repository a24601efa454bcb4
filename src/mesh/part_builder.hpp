#pragma once
// Cuts each rank's part out of the whole, on rank 0.

#include <vector>

#include "idiophone/mesh/part.hpp"

namespace idiophone::mesh {

/// Makes the parts of all ranks, one at a time.
class PartBuilder {
 public:
  /// @param meshes  all bodies' meshes; must outlive the builder
  /// @param owners  [global nodes] the rank that owns it
  PartBuilder(const std::vector<Mesh>& meshes, std::vector<int> owners);

  [[nodiscard]] Part build(int rank);

 private:
  void number_owned_nodes(int rank, Part& part);
  void take_elements(int rank, Part& part);
  void number_ghosts(Part& part);
  void take_surface(int rank, Part& part);
  [[nodiscard]] bool owns(int rank, Index node) const { return owners_[node] == rank; }
  [[nodiscard]] const Vector3& position(Index node) const;

  const std::vector<Mesh>& meshes_;
  Offsets first_;                      ///< global numbers of each body
  std::vector<int> owners_;            ///< [global nodes]
  std::vector<Index> owned_numbers_;   ///< [global nodes] local number on the owning rank
  std::vector<Index> vertex_numbers_;  ///< [global nodes] number among all surface nodes, or -1
  Index vertices_ = 0;                 ///< surface nodes
  std::vector<Index> local_;           ///< [global nodes] local number in the part being built, or -1
};

}  // namespace idiophone::mesh
