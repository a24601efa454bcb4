#include "surface_reader.hpp"

#include <algorithm>
#include <utility>

#include "compressed_rows.hpp"
#include "idiophone/foundation/parallel/broadcast.hpp"
#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/foundation/parallel/exchange.hpp"
#include "part_tables.hpp"
#include "together.hpp"

namespace idiophone::mesh {

namespace {

struct NumberedTriangle {
  Index number;
  Triangle nodes;  ///< as the file has them
};

Index lowest(const Triangle& triangle) {
  return triangle.front();
}

/// Gives triangles to the processes that have their lowest nodes. Collective.
/// @param first_number  of the triangles
/// @return by ascending numbers
std::vector<NumberedTriangle> exchange_by_lowest(const std::vector<Triangle>& triangles, Index first_number,
                                                 Index first_node, const NodeDivision& division,
                                                 MPI_Comm communicator) {
  const CompressedRows lists(division.processes(), [&](auto list) {
    for (std::size_t place = 0; place < triangles.size(); ++place) {
      list(division.process_of(first_node + lowest(triangles[place])), static_cast<Index>(place));
    }
  });
  std::vector<NumberedTriangle> given;
  std::vector<int> counts;
  for (int process = 0; process < division.processes(); ++process) {
    counts.push_back(static_cast<int>(lists[process].size()));
    for (const Index place : lists[process]) {
      given.push_back({first_number + place, triangles[place]});
    }
  }
  std::vector<NumberedTriangle> taken = parallel::exchange<NumberedTriangle>(given, counts, communicator);
  std::ranges::sort(taken, {}, &NumberedTriangle::number);
  return taken;
}

/// The triangles of a process's range of nodes. They are sorted by their lowest nodes. Collective.
/// @return first, and one past the last
std::pair<Index, Index> range_of_triangles(const Mesh& outline, Index first_node, const NodeDivision& division,
                                           MPI_Comm communicator) {
  std::vector<std::pair<Index, Index>> ranges;
  const auto place_of = [&](Index node) {
    return static_cast<Index>(std::ranges::lower_bound(outline.surface, node - first_node, {}, lowest) -
                              outline.surface.begin());
  };
  for (int process = 0; process < division.processes(); ++process) {
    const auto [begin, end] = division.range_of(process);
    ranges.emplace_back(place_of(begin), place_of(end));
  }
  parallel::broadcast(ranges, communicator);
  return ranges[parallel::rank_of(communicator)];
}

}  // namespace

SurfaceRows surface_around(const scene::Body& body, const Mesh& outline, Index first_node,
                           std::span<const std::size_t> node_tags, const NodeDivision& division,
                           MPI_Comm communicator) {
  const std::pair<Index, Index> range = range_of_triangles(outline, first_node, division, communicator);
  std::vector<Triangle> read;
  read_together(body, communicator, [&] { read = read_triangles(body, range.first, range.second); });
  SurfaceRows rows;
  const auto taken = exchange_by_lowest(read, range.first, first_node, division, communicator);
  read_together(body, communicator, [&] {
    for (const auto& [number, nodes] : taken) {
      rows.numbers.push_back(number);
      rows.triangles.push_back(in_places(nodes, node_tags));
    }
  });
  return rows;
}

}  // namespace idiophone::mesh
