#include "part_tables.hpp"

#include <algorithm>
#include <utility>

#include "mesh_file_paths.hpp"
#include "mesh_table_reader.hpp"

namespace idiophone::mesh {

namespace {

/// @throws std::runtime_error where the list does not have the node
Index place_of(Index node, std::span<const std::size_t> numbers) {
  const auto place = std::ranges::lower_bound(numbers, static_cast<std::size_t>(node));
  if (place == numbers.end() || std::cmp_not_equal(*place, node)) {
    refuse_table(mesh_file::surface, "has a triangle that is on no element");
  }
  return static_cast<Index>(place - numbers.begin());
}

}  // namespace

std::vector<Vector3> read_nodes(const scene::Body& body, std::span<const std::size_t> numbers) {
  constexpr std::size_t small_gap = 1000;
  const MeshTables tables(body.mesh);
  std::vector<Vector3> nodes;
  for (auto first = numbers.begin(); first != numbers.end();) {
    const auto last =
        std::adjacent_find(first, numbers.end(), [](std::size_t a, std::size_t b) { return b - a > small_gap; });
    const auto end = last == numbers.end() ? last : last + 1;
    const auto rows = tables.read_rows<double, Vector3>(mesh_file::nodes, 3, static_cast<Index>(*first),
                                                        static_cast<Index>(*(end - 1)) + 1);
    std::transform(first, end, std::back_inserter(nodes), [&](std::size_t number) { return rows[number - *first]; });
    first = end;
  }
  return nodes;
}

std::vector<Triangle> read_triangles(const scene::Body& body, Index begin, Index end) {
  return MeshTables(body.mesh).read_rows<Index, Triangle>(mesh_file::surface, 3, begin, end);
}

Triangle in_places(Triangle triangle, std::span<const std::size_t> numbers) {
  std::ranges::for_each(triangle, [&](Index& node) { node = place_of(node, numbers); });
  return triangle;
}

}  // namespace idiophone::mesh
