#include "local_pressures.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace idiophone::propagation {

std::array<LocalPressures::Corner, 8> LocalPressures::corners(const Vector3& in_cells) const {
  std::array<int, 3> first{};
  Vector3 part;
  for (int axis = 0; axis < 3; ++axis) {
    first[axis] = static_cast<int>(std::floor(in_cells[axis] - 0.5));
    part[axis] = in_cells[axis] - 0.5 - first[axis];
  }
  std::array<Corner, 8> corners{};
  for (int corner = 0; corner < 8; ++corner) {
    std::array<int, 3> cell = first;
    double weight = 1.0;
    for (int axis = 0; axis < 3; ++axis) {
      const bool upper = (corner >> axis & 1) != 0;
      cell[axis] += upper ? 1 : 0;
      weight *= upper ? part[axis] : 1.0 - part[axis];
    }
    cell[2] = std::max(cell[2], 0);  // below is the mirror image
    const waves::Subdomain& subdomain = field_.subdomain();
    corners[corner] = {subdomain.owns(cell) ? std::optional(subdomain.number(cell)) : std::nullopt, weight};
  }
  return corners;
}

void LocalPressures::begin(std::span<const Vector3> places) {
  std::vector<Index> cells;
  for (const Vector3& place : places) {
    const Vector3 in_cells = field_.subdomain().grid().in_cells(place);
    if (!enclosure_.contains(in_cells)) {
      continue;
    }
    for (const Corner& corner : corners(in_cells)) {
      if (corner.cell) {
        cells.push_back(*corner.cell);
      }
    }
  }
  if (!probe_ || cells != cells_) {
    cells_ = std::move(cells);
    probe_ = field_.probe(cells_);
  }
  probe_->begin();
}

void LocalPressures::finish() {
  pressures_ = probe_->finish();
}

std::optional<Ears::LocalSounds> LocalPressures::at(const Vector3& place) const {
  const Vector3 in_cells = field_.subdomain().grid().in_cells(place);
  if (!enclosure_.contains(in_cells)) {
    return {};
  }
  Ears::LocalSounds sounds{};
  const std::array<Corner, 8> around = corners(in_cells);
  for (std::size_t i = 0; i < around.size(); ++i) {
    if (!around[i].cell) {
      continue;
    }
    const auto found = std::ranges::find(cells_, *around[i].cell);
    if (found == cells_.end()) {
      throw std::logic_error("LocalPressures::at: begin() did not have this place");
    }
    sounds[i] = around[i].weight * pressures_[found - cells_.begin()];
  }
  return sounds;
}

}  // namespace idiophone::propagation
