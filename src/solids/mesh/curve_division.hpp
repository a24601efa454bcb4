#pragma once
// Which rank owns which nodes where no rank has the whole mesh: each has a range of the numbers, which run along a
// space-filling curve.

#include <mpi.h>

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
  /// @throws std::runtime_error, on every rank, where a rank would have no nodes
  [[nodiscard]] std::vector<Index> divide(MPI_Comm communicator) const;

 private:
  [[nodiscard]] std::size_t bin_of(Index node) const;

  Index nodes_;
  std::vector<std::int64_t> bins_;  ///< of this rank's elements
};

/// The rank that owns a node.
/// @param first  as divide() gives it
[[nodiscard]] int owner_of(Index node, const std::vector<Index>& first);

}  // namespace idiophone::mesh
