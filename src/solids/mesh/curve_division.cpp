#include "curve_division.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/foundation/parallel/reduce.hpp"

namespace idiophone::mesh {

namespace {

constexpr Index most_bins = 1 << 18;  ///< 2 MB

}  // namespace

WorkOfNodes::WorkOfNodes(Index nodes) : nodes_(nodes), bins_(std::min(nodes, most_bins)) {}

std::size_t WorkOfNodes::bin_of(Index node) const {
  return static_cast<std::size_t>(node) * bins_.size() / static_cast<std::size_t>(nodes_);
}

std::vector<Index> WorkOfNodes::divide(MPI_Comm communicator) const {
  const int ranks = parallel::size_of(communicator);
  std::vector<std::int64_t> work = bins_;
  parallel::reduce(work, MPI_SUM, communicator);
  std::partial_sum(work.begin(), work.end(), work.begin());
  std::vector<Index> first = {0};
  for (int rank = 1; rank < ranks; ++rank) {
    const std::int64_t below = work.back() / ranks * rank;
    const auto bin = static_cast<std::size_t>(std::ranges::lower_bound(work, below) - work.begin()) + 1;
    // The first node of this bin, rounded up as bin_of() rounds down.
    first.push_back(static_cast<Index>((bin * static_cast<std::size_t>(nodes_) + bins_.size() - 1) / bins_.size()));
  }
  first.push_back(nodes_);
  if (std::ranges::adjacent_find(first, std::ranges::greater_equal()) != first.end()) {
    throw std::runtime_error(fmt::format("{} ranks are too many for {} nodes: use fewer", ranks, nodes_));
  }
  return first;
}

int owner_of(Index node, const std::vector<Index>& first) {
  return static_cast<int>(std::ranges::upper_bound(first, node) - first.begin()) - 1;
}

}  // namespace idiophone::mesh
