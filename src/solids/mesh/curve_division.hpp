#pragma once
// Which rank owns which nodes where no rank has the whole mesh: each has a range of the numbers, which run along a
// space-filling curve, but for a few nodes that stay with others.

#include <mpi.h>

#include <utility>
#include <vector>

#include "idiophone/foundation/types.hpp"

namespace idiophone::mesh {

/// Adds up the work that nodes cause, in bins of nodes with numbers one after another.
class WorkOfNodes {
 public:
  /// @param nodes  over all bodies
  explicit WorkOfNodes(Index nodes);

  void add(Index node, int work) { bins_[bin_of(node)] += work; }

  /// The first node of each rank, and one past the last: [ranks + 1]. The ranks' work is about the same. Collective.
  /// @param ranks  that share the nodes, whether or not there are processes for them
  /// @throws std::runtime_error, on every process, where a rank would have no nodes
  [[nodiscard]] std::vector<Index> divide(int ranks, MPI_Comm communicator) const;

 private:
  [[nodiscard]] std::size_t bin_of(Index node) const;

  Index nodes_;
  std::vector<std::int64_t> bins_;  ///< of this process's elements
};

/// A node that another rank owns than the one whose range it lies in.
struct MovedNode {
  Index node = 0;
  int owner = 0;
};

/// The ranks, each with the nodes that it owns. Each process has some of the ranks, one after another; in a run, one.
class NodeDivision {
 public:
  /// @param first      as WorkOfNodes::divide() gives it
  /// @param moved      ascending, each node once
  /// @param processes  at most as many as ranks
  /// @throws std::runtime_error where a rank has no nodes
  NodeDivision(std::vector<Index> first, std::vector<MovedNode> moved, int processes);

  [[nodiscard]] int owner_of(Index node) const;
  /// The place of a node among those that its owner has, by ascending numbers.
  [[nodiscard]] Index place_on_owner(Index node) const;
  /// The process that has the rank that owns the node.
  [[nodiscard]] int process_of(Index node) const { return static_cast<int>(process_of_rank(owner_of(node))); }
  /// The ranks of a process: first, and one past the last.
  [[nodiscard]] std::pair<int, int> ranks_of(int process) const;
  /// The range of numbers of a process, including those that moved away: first, and one past the last.
  [[nodiscard]] std::pair<Index, Index> range_of(int process) const;
  /// Nodes in the range of a process that another process has, ascending.
  [[nodiscard]] std::vector<Index> away_from(int process) const;
  [[nodiscard]] int processes() const { return processes_; }

 private:
  [[nodiscard]] int range_with(Index node) const;
  [[nodiscard]] std::int64_t process_of_rank(int rank) const;
  /// Nodes below a number that the rank owns.
  [[nodiscard]] Index owned_below(int rank, Index node) const;

  std::vector<Index> first_;                    ///< [ranks + 1] of the ranges
  std::vector<MovedNode> moved_;                ///< by nodes
  std::vector<std::pair<int, Index>> arrived_;  ///< the same: owner and node, ascending
  int processes_;
};

}  // namespace idiophone::mesh
