#pragma once
// The small pieces of a side over which the depth of a cut is summed.

#include <Eigen/SparseCore>
#include <array>
#include <vector>

#include "idiophone/solids/mesh/mesh.hpp"
#include "idiophone/study/bench/cut_model.hpp"
#include "idiophone/study/bench/cut_side.hpp"

namespace idiophone::bench {

/// All faces of a side, cut into pieces, and how the nodes share what is there. Hexahedra have their own shape
/// functions, so that a polynomial of their order is as it is. Tetrahedra have linear ones of their straight triangles,
/// because quadratic ones give corners nothing.
class SidePieces {
 public:
  /// @param faces  triangles of the side
  SidePieces(const mesh::Mesh& mesh, const std::vector<mesh::Triangle>& faces, const Side& side);

  /// Mean depth of cuts around each node of the side, weighted by its shape function; zero at all others. [nodes] m
  [[nodiscard]] Eigen::VectorXd depths_of(const std::vector<Cut>& cuts) const;

 private:
  std::vector<std::array<double, 2>> ends_;  ///< [pieces] m, along the side, ascending
  Eigen::SparseMatrix<double, Eigen::RowMajor>
      shares_;  ///< [nodes x pieces] of what is around a node; they add up to 1
};

}  // namespace idiophone::bench
