#pragma once
// Continuous symmetric stresses on a mesh of hexahedra without traction on its free faces.

#include <petscsys.h>

#include <Eigen/Core>
#include <vector>

#include "idiophone/foundation/dense/dense.hpp"
#include "idiophone/solids/mesh/mesh.hpp"

namespace idiophone::eigenmodes {

/// The place of the stress s_ik among solid::direction_pairs.
[[nodiscard]] constexpr int stress_component(int i, int k) {
  return i == k ? i : 6 - i - k;
}

/// Stresses of one order above the displacements of a mesh, at the nodes of the refined mesh. Where the mesh ends and
/// no displacement is held, the traction is zero, at all points of the face.
class StressSpace {
 public:
  /// The stresses that are possible at a node.
  struct NodeBasis {
    dense::Matrix6 vectors;  ///< orthonormal columns, of which the first ones count
    Eigen::Index count;
  };

  /// @param mesh  of hexahedra
  /// @param held  [3 x nodes] components of the displacement that are held
  /// @throws std::runtime_error where a free face is curved, or a component is held at nodes that make up no face
  StressSpace(const mesh::Mesh& mesh, const std::vector<bool>& held);

  [[nodiscard]] element::Type type() const { return refined_.element; }
  [[nodiscard]] std::span<const Index> element_nodes(Index element) const { return refined_.element_nodes(element); }
  [[nodiscard]] std::size_t nodes() const { return bases_.size(); }
  [[nodiscard]] const NodeBasis& basis(Index node) const { return bases_[node]; }
  /// The number of a node's first unknown; that of all unknowns for the number of nodes.
  [[nodiscard]] PetscInt first(std::size_t node) const { return first_[node]; }
  [[nodiscard]] PetscInt size() const { return first_.back(); }  ///< unknowns

 private:
  mesh::Mesh refined_;
  std::vector<NodeBasis> bases_;  ///< [nodes]
  std::vector<PetscInt> first_;   ///< [nodes + 1]
};

}  // namespace idiophone::eigenmodes
