#include <algorithm>
#include <array>
#include <numeric>

#include "compressed_rows.hpp"
#include "connected_parts.hpp"
#include "idiophone/foundation/disjoint_sets.hpp"
#include "idiophone/foundation/each_once.hpp"
#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/foundation/parallel/exchange.hpp"
#include "neighbourhood.hpp"

namespace idiophone::mesh {

namespace {

/// A node, and the number of the part that it lies in on one process.
using Membership = std::array<Index, 2>;

/// What a process says of its ghosts to their owners.
std::vector<Membership> told_of_ghosts(const GmshMesh& loaded, std::span<const Index> parts, Index first_node,
                                       const NodeDivision& division, MPI_Comm communicator) {
  const CompressedRows ghosts(division.processes(), [&](auto list) {
    for (std::size_t place = 0; place < parts.size(); ++place) {
      const int process = division.process_of(first_node + static_cast<Index>(loaded.node_tags[place]));
      if (process != parallel::rank_of(communicator)) {
        list(process, static_cast<Index>(place));
      }
    }
  });
  std::vector<Membership> told;
  std::vector<int> counts;
  for (int process = 0; process < division.processes(); ++process) {
    counts.push_back(static_cast<int>(ghosts[process].size()));
    for (const Index place : ghosts[process]) {
      told.push_back({static_cast<Index>(loaded.node_tags[place]), parts[place]});
    }
  }
  return parallel::exchange<Membership>(told, counts, communicator);
}

}  // namespace

Index count_connected(const GmshMesh& loaded, Index first_node, const NodeDivision& division, MPI_Comm communicator) {
  std::vector<Index> parts = connected_parts(loaded.mesh);
  const auto counts = parallel::gather(parts.empty() ? 0 : std::ranges::max(parts) + 1, communicator);
  const Index before = std::accumulate(counts.begin(), counts.begin() + parallel::rank_of(communicator), Index{0});
  std::ranges::for_each(parts, [&](Index& part) { part += before; });
  std::vector<Membership> joined;  // parts of two processes
  for (const auto& [node, part] : told_of_ghosts(loaded, parts, first_node, division, communicator)) {
    const auto place = std::ranges::lower_bound(loaded.node_tags, static_cast<std::size_t>(node));
    joined.push_back({part, parts[place - loaded.node_tags.begin()]});
  }
  keep_each_once(joined);
  const Index all = std::accumulate(counts.begin(), counts.end(), Index{0});
  DisjointSets sets(static_cast<std::size_t>(all));
  for (const auto& [a, b] : parallel::gather_all<Membership>(joined, communicator).values) {
    sets.join(a, b);
  }
  Index count = 0;
  for (Index part = 0; part < all; ++part) {
    count += sets.root(part) == part ? 1 : 0;
  }
  return count;
}

}  // namespace idiophone::mesh
