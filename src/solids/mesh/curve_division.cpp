#include "curve_division.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "idiophone/foundation/parallel/reduce.hpp"

namespace idiophone::mesh {

namespace {

constexpr Index most_bins = 1 << 18;  ///< 2 MB

[[noreturn]] void refuse_ranks(int ranks, Index nodes) {
  throw std::runtime_error(fmt::format("{} ranks are too many for {} nodes: use fewer", ranks, nodes));
}

}  // namespace

WorkOfNodes::WorkOfNodes(Index nodes) : nodes_(nodes), bins_(std::min(nodes, most_bins)) {}

std::size_t WorkOfNodes::bin_of(Index node) const {
  return static_cast<std::size_t>(node) * bins_.size() / static_cast<std::size_t>(nodes_);
}

std::vector<Index> WorkOfNodes::divide(int ranks, MPI_Comm communicator) const {
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
    refuse_ranks(ranks, nodes_);
  }
  return first;
}

NodeDivision::NodeDivision(std::vector<Index> first, std::vector<MovedNode> moved, int processes)
    : first_(std::move(first)), moved_(std::move(moved)), processes_(processes) {
  for (const auto& [node, owner] : moved_) {
    arrived_.emplace_back(owner, node);
  }
  std::ranges::sort(arrived_);
  const int ranks = static_cast<int>(first_.size()) - 1;
  for (int rank = 0; rank < ranks; ++rank) {
    if (owned_below(rank, first_.back()) == 0) {
      refuse_ranks(ranks, first_.back());
    }
  }
}

int NodeDivision::range_with(Index node) const {
  return static_cast<int>(std::ranges::upper_bound(first_, node) - first_.begin()) - 1;
}

int NodeDivision::owner_of(Index node) const {
  const auto moved = std::ranges::lower_bound(moved_, node, {}, &MovedNode::node);
  return moved != moved_.end() && moved->node == node ? moved->owner : range_with(node);
}

Index NodeDivision::owned_below(int rank, Index node) const {
  const Index begin = first_[rank], end = std::clamp(node, begin, first_[rank + 1]);
  const auto moved_below = [&](Index limit) { return std::ranges::lower_bound(moved_, limit, {}, &MovedNode::node); };
  const auto arrived_below = [&](Index limit) { return std::ranges::lower_bound(arrived_, std::pair(rank, limit)); };
  return end - begin - static_cast<Index>(moved_below(end) - moved_below(begin)) +
         static_cast<Index>(arrived_below(node) - arrived_below(0));
}

Index NodeDivision::place_on_owner(Index node) const {
  return owned_below(owner_of(node), node);
}

std::int64_t NodeDivision::process_of_rank(int rank) const {
  return (std::int64_t{processes_} * (rank + 1) - 1) / (std::ssize(first_) - 1);
}

std::pair<int, int> NodeDivision::ranks_of(int process) const {
  const auto begin = [&](std::int64_t number) {
    return static_cast<int>(number * (std::ssize(first_) - 1) / processes_);
  };
  return {begin(process), begin(process + 1)};
}

std::pair<Index, Index> NodeDivision::range_of(int process) const {
  const auto [begin, end] = ranks_of(process);
  return {first_[begin], first_[end]};
}

std::vector<Index> NodeDivision::away_from(int process) const {
  std::vector<Index> away;
  for (const auto& [node, owner] : moved_) {
    if (process_of_rank(range_with(node)) == process && process_of_rank(owner) != process) {
      away.push_back(node);
    }
  }
  return away;
}

}  // namespace idiophone::mesh
