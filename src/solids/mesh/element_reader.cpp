#include "element_reader.hpp"

#include "hash_of_rows.hpp"
#include "idiophone/files/checksum.hpp"
#include "idiophone/foundation/parallel/communicator.hpp"
#include "mesh_file_paths.hpp"
#include "mesh_outline.hpp"
#include "mesh_table_reader.hpp"
#include "region_reader.hpp"
#include "together.hpp"

namespace idiophone::mesh {

namespace {

ElementRows read_rows(const scene::Body& body, Index element_count, Index node_count, MPI_Comm communicator) {
  const int width = element::node_count(body.element);
  const int rank = parallel::rank_of(communicator), ranks = parallel::size_of(communicator);
  ElementRows rows;
  rows.begin = first_row(element_count, rank, ranks);
  std::int64_t promised = 0;
  read_together(body, communicator, [&] {
    const MeshTables tables(body.mesh);
    const Index end = first_row(element_count, rank + 1, ranks);
    rows.nodes = tables.read_rows<Index, Index>(mesh_file::elements, width, rows.begin, end);
    promised = tables.checksum(mesh_file::elements);
  });
  const std::uint32_t found = files::checksum_of_blocks(std::as_bytes(std::span(rows.nodes)), communicator);
  read_together(body, communicator, [&] {
    require_checksum(mesh_file::elements, promised, found);
    require_numbers(mesh_file::elements, rows.nodes, static_cast<std::size_t>(node_count));
  });
  return rows;
}

}  // namespace

Index first_row(Index element_count, int rank, int ranks) {
  return static_cast<Index>(std::int64_t{element_count} * rank / ranks);
}

ElementRows read_element_rows(const scene::Body& body, const Mesh& outline, Index element_count, Index node_count,
                              MPI_Comm communicator) {
  ElementRows rows = read_rows(body, element_count, node_count, communicator);
  const std::string hash = hash_of_rows(outline, rows, element_count, communicator);
  read_together(body, communicator, [&] {
    if (parallel::is_root(communicator)) {
      require_hash(hash, outline.hash);
    }
  });
  read_regions(body, element_count, rows, communicator);
  return rows;
}

}  // namespace idiophone::mesh
