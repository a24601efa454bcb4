#include "accelerator_sources.hpp"

#include <algorithm>

namespace idiophone::waves {

namespace {

using Piece = SurfaceSources::Piece;

static_assert(sizeof(Piece) == 2 * sizeof(Index) + sizeof(float));  // as in sources.cl

std::vector<Index> first_pieces(const std::vector<Piece>& pieces, Index nodes) {
  std::vector<Index> first;
  for (Index node = 0; node <= nodes; ++node) {
    first.push_back(static_cast<Index>(std::ranges::lower_bound(pieces, node, {}, &Piece::node) - pieces.begin()));
  }
  return first;
}

}  // namespace

AcceleratorSources::AcceleratorSources(WaveKernels& kernels, const SurfaceSources& sources, Index nodes, int steps)
    : kernels_(kernels),
      nodes_(nodes),
      steps_(steps),
      first_piece_(kernels.program.accelerator(), first_pieces(sources.pieces(), nodes)),
      pieces_(kernels.program.accelerator(), std::span<const Piece>(sources.pieces())),
      sources_(kernels.program.accelerator(), static_cast<std::size_t>(steps) * nodes) {}

const accelerator::Array<float>& AcceleratorSources::of(const AcceleratorVelocities& velocities) {
  if (oldest_ != velocities.oldest()) {
    oldest_ = velocities.oldest();
    kernels_.add_sources({sources_.size(), 1, 1}, nodes_, steps_, static_cast<int>(velocities.history().signals()),
                         first_piece_, pieces_, velocities.changes(), sources_);
  }
  return sources_;
}

}  // namespace idiophone::waves
