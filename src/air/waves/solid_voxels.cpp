#include "solid_voxels.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace idiophone::waves {

namespace {

/// Twice the area of (a, b, point) seen along x. Exactly the opposite for (b, a, point), so that a line on an edge
/// passes through one of its two triangles.
double side(const Vector3& a, const Vector3& b, double y, double z) {
  const bool ordered = std::tie(a[1], a[2], a[0]) < std::tie(b[1], b[2], b[0]);
  const Vector3& first = ordered ? a : b;
  const Vector3& second = ordered ? b : a;
  const double value = (second[1] - first[1]) * (z - first[2]) - (second[2] - first[2]) * (y - first[1]);
  const double signed_value = value == 0.0 ? std::numeric_limits<double>::min() : value;
  return ordered ? signed_value : -signed_value;
}

/// Centres of sub-voxels from one coordinate to another: numbers from first to before last.
std::pair<int, int> centres(double from, double to) {
  return {static_cast<int>(std::ceil(from - 0.5)), static_cast<int>(std::ceil(to - 0.5))};
}

}  // namespace

SolidVoxels::SolidVoxels(const Subdomain& subdomain, const Obstruction& obstruction) {
  find_box(subdomain, obstruction);
  if (box_.is_empty()) {
    return;
  }
  crossings_.resize(box_.to[2] - box_.from[2]);
  for (Index t = 0; t < static_cast<Index>(obstruction.triangles.size()); ++t) {
    std::array<Vector3, 3> corners;
    for (int k = 0; k < 3; ++k) {
      corners[k] = voxels * subdomain.grid().in_cells(obstruction.corner(t, k));
    }
    cross(corners);
  }
  contents_.assign(box_.size(), air);
  std::vector<Mask> plane(static_cast<std::size_t>(box_.to[0] - box_.from[0]) * (box_.to[1] - box_.from[1]));
  for (int z = box_.from[2]; z < box_.to[2]; ++z) {
    fill_plane(z, plane);
  }
  crossings_.clear();
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

void SolidVoxels::cross(const std::array<Vector3, 3>& triangle) {
  const auto& [a, b, c] = triangle;
  const auto [y_low, y_high] = std::minmax({a[1], b[1], c[1]});
  const auto [z_low, z_high] = std::minmax({a[2], b[2], c[2]});
  const auto lines = [this](std::size_t axis, double low, double high) {
    return centres(std::max<double>(voxels * box_.from.at(axis), low),
                   std::min<double>(voxels * box_.to.at(axis), high));
  };
  const auto [y_from, y_to] = lines(1, y_low, y_high);
  const auto [z_from, z_to] = lines(2, z_low, z_high);
  for (int z = z_from; z < z_to; ++z) {
    for (int y = y_from; y < y_to; ++y) {
      const double at_a = side(b, c, y + 0.5, z + 0.5);
      const double at_b = side(c, a, y + 0.5, z + 0.5);
      const double at_c = side(a, b, y + 0.5, z + 0.5);
      const bool forwards = at_a > 0 && at_b > 0 && at_c > 0;
      if (forwards || (at_a < 0 && at_b < 0 && at_c < 0)) {
        const double x = (at_a * a[0] + at_b * b[0] + at_c * c[0]) / (at_a + at_b + at_c);
        const Index line = (z % voxels) * voxels * (box_.to[1] - box_.from[1]) + y - voxels * box_.from[1];
        crossings_[z / voxels - box_.from[2]].push_back({line, static_cast<float>(x), forwards ? -1 : 1});
      }
    }
  }
}

void SolidVoxels::fill_plane(int z, std::vector<Mask>& plane) {
  auto& crossings = crossings_[z - box_.from[2]];
  if (crossings.empty()) {
    return;
  }
  std::ranges::fill(plane, Mask{});
  std::ranges::sort(crossings, {}, [](const Crossing& c) { return std::tuple(c.line, c.x, -c.direction); });
  int winding = 0;
  for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
    if (i == 0 || crossings[i].line != crossings[i - 1].line) {
      winding = 0;
    }
    winding += crossings[i].direction;
    if (winding > 0 && crossings[i + 1].line == crossings[i].line) {
      fill_line(crossings[i].line, crossings[i].x, crossings[i + 1].x, plane);
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

void SolidVoxels::fill_line(Index line, double from, double to, std::vector<Mask>& plane) const {
  const int width = box_.to[0] - box_.from[0];
  const int y = line % (voxels * (box_.to[1] - box_.from[1]));
  const int layer = line / (voxels * (box_.to[1] - box_.from[1]));
  const int offset = voxels * box_.from[0];
  const auto [first, last] = centres(std::max(0.0, from - offset), std::min<double>(voxels * width, to - offset));
  for (int x = first; x < last; ++x) {
    plane[static_cast<std::size_t>(y / voxels) * width + x / voxels][layer] |= std::uint64_t{1}
                                                                               << (voxels * (y % voxels) + x % voxels);
  }
}

}  // namespace idiophone::waves
