#include "cell_neighbours.hpp"

#include <algorithm>

#include "idiophone/foundation/each_once.hpp"

namespace idiophone::contact {

CellNeighbours::CellNeighbours(const Skin& skin) : skin_(&skin), first_{0}, seen_from_(skin.nodes.size(), -1) {
  std::vector<std::vector<Index>> beside(skin.nodes.size());
  for (const auto& cell : skin.cells) {
    for (const Index node : cell) {
      beside[node].insert(beside[node].end(), cell.begin(), cell.end());
    }
  }
  for (std::vector<Index>& nodes : beside) {
    keep_each_once(nodes);
    beside_.insert(beside_.end(), nodes.begin(), nodes.end());
    first_.push_back(static_cast<Index>(beside_.size()));
  }
}

void CellNeighbours::look_from(Index cell) {
  cell_ = cell;
  for (const Index node : skin_->cells[cell]) {
    for (Index i = first_[node]; i < first_[node + 1]; ++i) {
      seen_from_[beside_[i]] = cell;
    }
  }
}

bool CellNeighbours::is_near(Index cell) const {
  return std::ranges::any_of(skin_->cells[cell], [&](Index node) { return seen_from_[node] == cell_; });
}

}  // namespace idiophone::contact
