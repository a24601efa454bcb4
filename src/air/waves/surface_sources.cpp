#include "idiophone/air/waves/surface_sources.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "surface_pieces.hpp"

namespace idiophone::waves {

SurfaceSources::SurfaceSources(const Subdomain& subdomain, const Obstruction& obstruction, std::size_t moving,
                               const CutCells& cut_cells, double courant) {
  for (std::size_t triangle = 0; triangle < moving; ++triangle) {
    add_triangle(subdomain, obstruction, static_cast<Index>(triangle), cut_cells);
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
  const double face = subdomain.grid().cell * subdomain.grid().cell;
  for (Piece& piece : merged) {
    piece.weight *= static_cast<float>(courant / face) / cut_cells.nodes()[piece.node].volume;
  }
  pieces_ = std::move(merged);
  find_resistances(cut_cells.nodes().size());
}

void SurfaceSources::find_fronts(std::vector<Piece> areas, const CutCells& cut_cells) {
  std::ranges::sort(areas, {}, [](const Piece& piece) { return std::tuple(piece.triangle, piece.node); });
  for (const Piece& piece : areas) {
    fronts_.push_back({piece.node, piece.weight});
    shares_.push_back({.triangle = piece.triangle, .cell = cut_cells.nodes()[piece.node].cell});
  }
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

void SurfaceSources::add_triangle(const Subdomain& subdomain, const Obstruction& obstruction, Index triangle,
                                  const CutCells& cut_cells) {
  for_each_piece(subdomain, obstruction, triangle, [&](const SurfacePiece& piece) {
    const Index node = node_in_front(cut_cells, piece);
    if (node < 0 && subdomain.owns(cell_at(piece.centre))) {
      covered_area_ += piece.area;
    }
    if (node >= 0 && node < cut_cells.own_nodes()) {
      pieces_.push_back({node, triangle, static_cast<float>(piece.area)});
    }
  });
}

void SurfaceSources::add(std::span<const float> change, std::span<float> sources) const {
  std::ranges::fill(sources, 0.0F);
  for (const Piece& piece : pieces_) {
    sources[piece.node] += piece.weight * change[piece.triangle];
  }
}

const std::vector<ForceShare>& SurfaceSources::forces(std::span<const float> pressure) {
  for (std::size_t i = 0; i < shares_.size(); ++i) {
    shares_[i].force = static_cast<double>(fronts_[i].area) * pressure[fronts_[i].node];
  }
  return shares_;
}

}  // namespace idiophone::waves
