#pragma once
// Cuts each rank's part out of the whole, on rank 0.

#include <span>
#include <vector>

#include "compressed_rows.hpp"
#include "idiophone/solids/mesh/part.hpp"

namespace idiophone::mesh {

/// Makes the parts of all ranks, one at a time.
class PartBuilder {
 public:
  /// @param meshes   all bodies' meshes; must outlive the builder
  /// @param owners   [global nodes] the rank that owns it
  /// @param coupled  sets of nodes as distribute() takes them; must outlive the builder
  PartBuilder(const std::vector<Mesh>& meshes, std::vector<int> owners, std::span<const std::vector<Index>> coupled);

  [[nodiscard]] Part build(int rank);

 private:
  template <class Visit>
  void for_each_node(const Visit& visit) const;
  template <class Visit>
  void for_each_element(const Visit& visit) const;
  template <class Visit>
  void for_each_triangle(const Visit& visit) const;
  void number_owned_nodes(int rank, Part& part);
  void take_elements(int rank, Part& part);
  void number_ghosts(int rank, Part& part);
  void take_surface(int rank, Part& part);
  /// Appends a node to the part's local ones.
  void add_node(Index node, Part& part) const;

  const std::vector<Mesh>& meshes_;
  std::span<const std::vector<Index>> coupled_;
  Offsets first_;                      ///< global numbers of each body
  std::vector<Index> first_piece_;     ///< [bodies + 1] first piece of each body, over all bodies
  std::vector<int> owners_;            ///< [global nodes]
  int ranks_;                          ///< that own any
  CompressedRows nodes_;               ///< [ranks] global numbers, ascending, of those that it owns
  CompressedRows elements_;            ///< [ranks] likewise of those that it computes
  CompressedRows triangles_;           ///< [ranks] likewise of those that it owns
  std::vector<Index> owned_numbers_;   ///< [global nodes] local number on the owning rank
  std::vector<Index> vertex_numbers_;  ///< [global nodes] number among all surface nodes, or -1
  Index vertices_ = 0;                 ///< surface nodes
  std::vector<Index> local_;           ///< [global nodes] local number in the part being built, or -1
};

}  // namespace idiophone::mesh
