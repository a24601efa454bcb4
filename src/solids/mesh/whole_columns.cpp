#include "whole_columns.hpp"

#include <algorithm>
#include <utility>

#include "idiophone/foundation/parallel/gather.hpp"

namespace idiophone::mesh {

namespace {

/// @param lines  of an element through the thickness
void add_moved(std::span<const Index> element, std::size_t lines, Index first_node, const NodeDivision& ranges,
               std::vector<MovedNode>& moved) {
  for (std::size_t line = 0; line < lines; ++line) {
    Index lowest = element[line];
    for (std::size_t a = line; a < element.size(); a += lines) {
      lowest = std::min(lowest, element[a]);
    }
    const int owner = ranges.owner_of(first_node + lowest);
    for (std::size_t a = line; a < element.size(); a += lines) {
      const Index node = first_node + element[a];
      if (ranges.owner_of(node) != owner) {
        moved.push_back({node, owner});
      }
    }
  }
}

/// Sorts by nodes; of several owners of one, the lowest stays.
void keep_each_node_once(std::vector<MovedNode>& moved) {
  std::ranges::sort(moved, {}, [](const MovedNode& one) { return std::pair(one.node, one.owner); });
  const auto same_node = [](const MovedNode& a, const MovedNode& b) { return a.node == b.node; };
  moved.erase(std::unique(moved.begin(), moved.end(), same_node), moved.end());
}

}  // namespace

std::vector<MovedNode> nodes_moved_to_columns(std::span<const scene::Body> bodies, const std::vector<ElementRows>& rows,
                                              const std::vector<Index>& nodes, const std::vector<Index>& first,
                                              MPI_Comm communicator) {
  const NodeDivision ranges(first, {}, 1);
  std::vector<MovedNode> moved;
  for (std::size_t body = 0; body < bodies.size(); ++body) {
    if (!bodies[body].mass_scaling) {
      continue;
    }
    const auto width = static_cast<std::size_t>(element::node_count(bodies[body].element));
    const auto lines = static_cast<std::size_t>(element::lines_through(bodies[body].element));
    for (std::size_t place = 0; place < rows[body].nodes.size(); place += width) {
      add_moved(std::span(rows[body].nodes).subspan(place, width), lines, nodes[body], ranges, moved);
    }
  }
  keep_each_node_once(moved);
  std::vector<MovedNode> all = parallel::gather_all<MovedNode>(moved, communicator).values;
  keep_each_node_once(all);
  return all;
}

}  // namespace idiophone::mesh
