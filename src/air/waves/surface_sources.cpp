#include "idiophone/air/waves/surface_sources.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <tuple>

#include "sub_voxels.hpp"

namespace idiophone::waves {

namespace {

/// Distances in front of a surface where its air is sought, in sub-voxels; a cell's surface is known to one of them.
constexpr std::array in_front = {0.5, 1.0, 1.5, 2.0, 2.5, 0.0};

/// Pieces of triangles are about this long, in cells.
constexpr double piece_length = 0.25;

/// The node in front of a point of a surface; -1 for none.
Index node_in_front(const CutCells& cut_cells, const Vector3& in_cells, const Vector3& normal) {
  for (const double distance : in_front) {
    const Index node = cut_cells.node_at(in_cells + distance / voxels * normal);
    if (node >= 0) {
      return node;
    }
  }
  return -1;
}

}  // namespace

SurfaceSources::SurfaceSources(const Slab& slab, const Obstruction& obstruction, std::size_t moving,
                               const CutCells& cut_cells, double courant) {
  for (std::size_t triangle = 0; triangle < moving; ++triangle) {
    add_triangle(slab, obstruction, static_cast<Index>(triangle), cut_cells);
  }
  std::ranges::sort(pieces_, {}, [](const Piece& piece) { return std::tuple(piece.node, piece.triangle); });
  std::vector<Piece> merged;
  for (const Piece& piece : pieces_) {
    if (!merged.empty() && merged.back().node == piece.node && merged.back().triangle == piece.triangle) {
      merged.back().weight += piece.weight;
    } else {
      merged.push_back(piece);
    }
  }
  find_fronts(merged, cut_cells);
  const double face = slab.grid().cell * slab.grid().cell;
  for (Piece& piece : merged) {
    piece.weight *= static_cast<float>(courant / face) / cut_cells.nodes()[piece.node].volume;
  }
  pieces_ = std::move(merged);
  find_resistances(cut_cells.nodes().size());
}

void SurfaceSources::find_fronts(std::vector<Piece> areas, const CutCells& cut_cells) {
  std::ranges::sort(areas, {}, [](const Piece& piece) { return std::tuple(piece.triangle, piece.node); });
  const auto plane_of = [&](Index node) { return cut_cells.nodes()[node].cell[2]; };
  for (const Piece& piece : areas) {
    if (shares_.empty() || shares_.back().triangle != piece.triangle ||
        plane_of(fronts_.back().node) != plane_of(piece.node)) {
      shares_.push_back({.triangle = piece.triangle});
      first_front_.push_back(fronts_.size());
    }
    fronts_.push_back({piece.node, piece.weight});
  }
  first_front_.push_back(fronts_.size());
}

/// Two triangles with a node in common feel each other's velocity. These are the sums of the rows of that symmetric
/// matrix, so a diagonal matrix of them is at least as large.
void SurfaceSources::find_resistances(std::size_t nodes) {
  std::vector<float> half_step(nodes);  // what a velocity of 1/(rho c) adds to the pressures
  for (const Piece& piece : pieces_) {
    half_step[piece.node] += piece.weight / 2.0F;
  }
  static_cast<void>(forces(half_step));
  for (ForceShare& share : shares_) {
    share.resistance = share.force;
  }
}

void SurfaceSources::add_triangle(const Slab& slab, const Obstruction& obstruction, Index triangle,
                                  const CutCells& cut_cells) {
  const Grid& grid = slab.grid();
  const Vector3 a = grid.in_cells(obstruction.corner(triangle, 0));
  const Vector3 b = grid.in_cells(obstruction.corner(triangle, 1));
  const Vector3 c = grid.in_cells(obstruction.corner(triangle, 2));
  const auto [low, high] = std::minmax({a[2], b[2], c[2]});
  if (high < slab.begin() - 1 || low > slab.end() + 1) {
    return;
  }
  const Vector3 twice_area = (b - a).cross(c - a);
  const Vector3 normal = twice_area.normalized();
  const double longest = std::sqrt(std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()}));
  const int n = std::max(1, static_cast<int>(std::ceil(longest / piece_length)));
  const double area = 0.5 * twice_area.norm() * grid.cell * grid.cell / (n * n);
  const auto add_piece = [&](double u, double v) {
    const Vector3 centre = a + u / n * (b - a) + v / n * (c - a);
    const Index node = node_in_front(cut_cells, centre, normal);
    if (node < 0 && slab.owns(static_cast<int>(std::floor(centre[2])))) {
      covered_area_ += area;
    }
    if (node >= 0 && slab.owns(cut_cells.nodes()[node].cell[2])) {
      pieces_.push_back({node, triangle, static_cast<float>(area)});
    }
  };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; i + j < n; ++j) {
      add_piece(i + 1.0 / 3.0, j + 1.0 / 3.0);
      if (i + j < n - 1) {
        add_piece(i + 2.0 / 3.0, j + 2.0 / 3.0);
      }
    }
  }
}

void SurfaceSources::add(std::span<const float> change, std::span<float> sources) const {
  std::ranges::fill(sources, 0.0F);
  for (const Piece& piece : pieces_) {
    sources[piece.node] += piece.weight * change[piece.triangle];
  }
}

const std::vector<ForceShare>& SurfaceSources::forces(std::span<const float> pressure) {
  for (std::size_t s = 0; s < shares_.size(); ++s) {
    double force = 0.0;
    for (std::size_t f = first_front_[s]; f < first_front_[s + 1]; ++f) {
      force += static_cast<double>(fronts_[f].area) * pressure[fronts_[f].node];
    }
    shares_[s].force = force;
  }
  return shares_;
}

}  // namespace idiophone::waves
