#include "local_pressures.hpp"

#include <algorithm>
#include <cmath>

namespace idiophone::propagation {

std::optional<LocalPressures::Corners> LocalPressures::corners(const Vector3& place) const {
  const waves::Subdomain& subdomain = field_.subdomain();
  const Vector3 in_cells = subdomain.grid().in_cells(place);
  if (!enclosure_.contains(in_cells)) {
    return {};
  }
  std::array<int, 3> first{};
  Vector3 part;
  for (int axis = 0; axis < 3; ++axis) {
    first[axis] = static_cast<int>(std::floor(in_cells[axis] - 0.5));
    part[axis] = in_cells[axis] - 0.5 - first[axis];
  }
  Corners corners{};
  for (int corner = 0; corner < 8; ++corner) {
    std::array<int, 3> cell = first;
    double weight = 1.0;
    for (int axis = 0; axis < 3; ++axis) {
      const bool upper = (corner >> axis & 1) != 0;
      cell[axis] += upper ? 1 : 0;
      weight *= upper ? part[axis] : 1.0 - part[axis];
    }
    cell[2] = std::max(cell[2], 0);  // below is the mirror image
    corners[corner] = {subdomain.owns(cell) ? std::optional(subdomain.number(cell)) : std::nullopt, weight};
  }
  return corners;
}

void LocalPressures::begin(std::span<const Vector3> places) {
  std::vector<std::optional<Corners>> around;
  std::vector<Index> cells;
  for (const Vector3& place : places) {
    around.push_back(corners(place));
    for (std::size_t i = 0; around.back() && i < around.back()->size(); ++i) {
      if (const auto& cell = around.back()->at(i).cell) {
        cells.push_back(*cell);
      }
    }
  }
  if (!probe_) {
    cells_.resize(std::tuple_size_v<Corners> * places.size());  // as many as there can be
    probe_ = field_.probe(cells_);
  }
  if (cells != cells_) {
    probe_->set_cells(cells);
  }
  corners_ = std::move(around);
  cells_ = std::move(cells);
  probe_->begin();
}

void LocalPressures::finish() {
  sounds_.assign(corners_.size(), {});
  auto pressure = probe_->finish().begin();
  for (std::size_t place = 0; place < corners_.size(); ++place) {
    if (!corners_[place]) {
      continue;
    }
    Ears::LocalSounds& sounds = sounds_[place].emplace();
    std::ranges::transform(*corners_[place], sounds.begin(),
                           [&](const Corner& corner) { return corner.cell ? corner.weight * *pressure++ : 0.0; });
  }
}

}  // namespace idiophone::propagation
