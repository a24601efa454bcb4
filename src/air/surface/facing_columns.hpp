#pragma once
// Triangles of a surface, four at once, and how much of them faces the same way as one of them.

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "idiophone/foundation/lanes.hpp"
#include "idiophone/foundation/types.hpp"

namespace idiophone::surface {

/// A triangle as the air feels it from afar.
struct FlatPiece {
  Vector3 centre;  ///< m
  Vector3 area;    ///< times the normal, m2
};
[[nodiscard]] FlatPiece flat_piece(const std::array<Vector3, 3>& triangle);

/// Centres and areas as columns of four; those added as padding have no area.
class FacingColumns {
 public:
  /// @param count  of triangles
  explicit FacingColumns(std::size_t count) : centre_((count + lane_count - 1) / lane_count), area_(centre_.size()) {}

  void put(std::size_t place, const FlatPiece& piece);

  [[nodiscard]] std::size_t fours() const { return centre_.size(); }

  /// The sum over triangles of area max(0, n.n')/distance to the centre of one, m; without it, and others that have
  /// the same centre.
  /// @param begin, end  which fours
  [[nodiscard]] double sum(const FlatPiece& one, std::size_t begin, std::size_t end) const;

 private:
  std::vector<VectorLanes> centre_;  ///< m
  std::vector<VectorLanes> area_;    ///< times the normal, m2
};

/// All triangles of a surface in their order, three corners each, m.
[[nodiscard]] FacingColumns columns_of(std::span<const std::array<Vector3, 3>> surface);

}  // namespace idiophone::surface
