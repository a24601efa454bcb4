#pragma once
// Which cells of one skin are so near each other along the body that they are left out of its contact with itself:
// those that share a node, and those that share a node with one cell each. Elements keep these apart; only far parts of
// a body can meet.

#include <vector>

#include "idiophone/solids/contact/skin.hpp"

namespace idiophone::contact {

class CellNeighbours {
 public:
  /// @param skin  must outlive this object
  explicit CellNeighbours(const Skin& skin);

  /// Chooses the cell whose neighbours is_near() knows.
  void look_from(Index cell);

  /// Whether a cell is a neighbour, or the chosen one itself.
  [[nodiscard]] bool is_near(Index cell) const;

 private:
  const Skin* skin_;
  std::vector<Index> first_;      ///< [skin nodes + 1] neighbours of a node are beside_[first_[node], first_[node + 1])
  std::vector<Index> beside_;     ///< nodes that share a cell with it, and itself
  std::vector<Index> seen_from_;  ///< [skin nodes] the last cell beside which it was
  Index cell_ = -1;
};

}  // namespace idiophone::contact
