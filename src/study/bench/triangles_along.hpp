#pragma once
// Triangles of a surface, found by their place along an axis.

#include <span>
#include <vector>

#include "idiophone/solids/mesh/mesh.hpp"

namespace idiophone::bench {

class TrianglesAlong {
 public:
  /// @param axis  0, 1, 2 for x, y, z
  TrianglesAlong(const mesh::Mesh& mesh, std::span<const mesh::Triangle> triangles, int axis);

  /// All triangles that have this coordinate (m) between their ends, in their order, and some more.
  [[nodiscard]] const std::vector<mesh::Triangle>& at(double coordinate) const;

 private:
  [[nodiscard]] std::size_t strip_of(double coordinate) const;

  double low_ = 0.0;    ///< m
  double width_ = 1.0;  ///< of a strip, m
  std::vector<std::vector<mesh::Triangle>> strips_;
};

}  // namespace idiophone::bench
