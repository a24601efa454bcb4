#include "solid_voxels.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace idiophone::waves {

SolidVoxels::SolidVoxels(const Subdomain& subdomain, const Obstruction& obstruction) {
  find_box(subdomain, obstruction);
  if (box_.is_empty()) {
    return;
  }
  runs_.resize(box_.width(2));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const InnerPiece& piece : inner_pieces(obstruction, subdomain.grid(), box_, axis)) {
      add_piece(piece, axis);
    }
  }
  contents_.assign(box_.size(), air);
  for (int z = box_.from[2]; z < box_.to[2]; ++z) {
    fill_plane(z);
  }
  runs_.clear();
}

void SolidVoxels::find_box(const Subdomain& subdomain, const Obstruction& obstruction) {
  const Grid& grid = subdomain.grid();
  Eigen::AlignedBox3d box;  // in cells
  for (std::size_t i = 0; i < obstruction.positions.size(); i += 3) {
    const float* const x = &obstruction.positions[i];
    box.extend(grid.in_cells(Vector3(x[0], x[1], x[2])));
  }
  if (box.isEmpty()) {
    return;
  }
  const CellBox limits = common(subdomain.cells().grown(2), grid.all());
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto bounded = [&](double cells) {
      return static_cast<int>(
          std::clamp(cells, static_cast<double>(limits.from.at(axis)), static_cast<double>(limits.to.at(axis))));
    };
    box_.from.at(axis) = bounded(std::floor(box.min()[axis]) - 2);
    box_.to.at(axis) = bounded(std::floor(box.max()[axis]) + 3);
  }
}

/// Lines along x meet all centres, those along the other axes only find more sheets.
void SolidVoxels::add_piece(const InnerPiece& piece, std::size_t axis) {
  const std::size_t next = (axis + 1) % 3, last = (axis + 2) % 3;
  const auto [from, to] = centres(piece.from, piece.to);
  std::array<int, 3> place{};
  place.at(next) = piece.line % (voxels * box_.width(next));
  place.at(last) = piece.line / (voxels * box_.width(next));
  const auto in_box = [&](int number) {
    return std::clamp(number - voxels * box_.from.at(axis), 0, voxels * box_.width(axis));
  };
  if (from == to && piece.through_sheet) {
    const int middle = static_cast<int>(std::floor((piece.from + piece.to) / 2.0F));
    place.at(axis) = in_box(middle);
    add_run(place, in_box(middle + 1) - in_box(middle));
  } else if (axis == 0) {
    place[0] = in_box(from);
    add_run(place, in_box(to) - in_box(from));
  }
}

void SolidVoxels::add_run(const std::array<int, 3>& first, int length) {
  if (length > 0) {
    runs_[first[2] / voxels].push_back({first, length});
  }
}

void SolidVoxels::fill_plane(int z) {
  const auto& runs = runs_[z - box_.from[2]];
  if (runs.empty()) {
    return;
  }
  std::vector<Mask> plane(static_cast<std::size_t>(box_.width(0)) * box_.width(1));
  for (const auto& [first, length] : runs) {
    const std::size_t row = static_cast<std::size_t>(first[1] / voxels) * box_.width(0);
    for (int x = first[0]; x < first[0] + length; ++x) {
      plane[row + x / voxels][first[2] % voxels] |= std::uint64_t{1} << (voxels * (first[1] % voxels) + x % voxels);
    }
  }
  const std::size_t before = box_.place({box_.from[0], box_.from[1], z});
  for (std::size_t i = 0; i < plane.size(); ++i) {
    if (plane[i] == full_mask) {
      contents_[before + i] = solid;
    } else if (plane[i] != Mask{}) {
      contents_[before + i] = static_cast<Index>(masks_.size());
      masks_.push_back(plane[i]);
    }
  }
}

}  // namespace idiophone::waves
