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
  const double face = subdomain.grid().cell * subdomain.grid().cell;
  for (Piece& piece : merged) {
    piece.weight *= static_cast<float>(courant / face) / cut_cells.nodes()[piece.node].volume;
  }
  pieces_ = std::move(merged);
}

void SurfaceSources::add_triangle(const Subdomain& subdomain, const Obstruction& obstruction, Index triangle,
                                  const CutCells& cut_cells) {
  for_each_front(subdomain, obstruction, triangle, cut_cells, [&](Index node, const SurfacePiece& piece) {
    pieces_.push_back({node, triangle, static_cast<float>(piece.area)});
  });
}

void SurfaceSources::add(std::span<const float> change, std::span<float> sources) const {
  std::ranges::fill(sources, 0.0F);
  for (const Piece& piece : pieces_) {
    sources[piece.node] += piece.weight * change[piece.triangle];
  }
}

}  // namespace idiophone::waves
