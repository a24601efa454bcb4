#include "element_reader.hpp"

#include <algorithm>
#include <stdexcept>

#include "hash.hpp"
#include "idiophone/files/checksum.hpp"
#include "idiophone/files/reading.hpp"
#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/foundation/parallel/broadcast.hpp"
#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/foundation/parallel/errors.hpp"
#include "load_mesh_file.hpp"
#include "mesh_file_paths.hpp"
#include "mesh_outline.hpp"
#include "mesh_table_reader.hpp"

namespace idiophone::mesh {

namespace {

/// Of the whole mesh, on rank 0. The ranks take in their elements one after another. Collective.
std::string hash_of(const Mesh& outline, Index element_numbers, std::span<const Index> own, MPI_Comm communicator) {
  Fnv1a hash;
  if (parallel::is_root(communicator)) {
    add_nodes(outline, hash);
    hash.add_length(static_cast<std::uint64_t>(element_numbers));
  }
  for (int rank = 0; rank < parallel::size_of(communicator); ++rank) {
    parallel::broadcast(hash, communicator, std::max(rank - 1, 0));
    if (rank == parallel::rank_of(communicator)) {
      hash.add_bytes(std::as_bytes(own));
    }
  }
  parallel::broadcast(hash, communicator, parallel::size_of(communicator) - 1);
  add_surface_and_groups(outline, hash);
  return hash.text();
}

}  // namespace

void require_none(const scene::Body& body, const std::string& problem, MPI_Comm communicator) {
  std::string first;
  try {
    parallel::agree(communicator, problem);
  } catch (const std::runtime_error& error) {
    first = error.what();
  }
  parallel::on_root(communicator, [&] {
    if (!first.empty()) {
      throw deck::DeckError(body.mesh_where, first);
    }
  });
}

void read_together(const scene::Body& body, MPI_Comm communicator, const std::function<void()>& read) {
  std::string problem;
  try {
    files::read_within_limit(body.mesh, read);
  } catch (const std::runtime_error& error) {
    problem = unreadable(body, error.what());
  }
  require_none(body, problem, communicator);
}

ElementRows read_element_rows(const scene::Body& body, const Mesh& outline, Index element_count, Index node_count,
                              MPI_Comm communicator) {
  const int width = element::node_count(body.element);
  const std::int64_t rank = parallel::rank_of(communicator), ranks = parallel::size_of(communicator);
  ElementRows rows{.begin = static_cast<Index>(element_count * rank / ranks), .nodes = {}};
  std::int64_t promised = 0;
  read_together(body, communicator, [&] {
    const MeshTables tables(body.mesh);
    const auto end = static_cast<Index>(element_count * (rank + 1) / ranks);
    rows.nodes = tables.read_rows<Index, Index>(mesh_file::elements, width, rows.begin, end);
    promised = tables.checksum(mesh_file::elements);
  });
  const std::uint32_t found = files::checksum_of_blocks(std::as_bytes(std::span(rows.nodes)), communicator);
  read_together(body, communicator, [&] {
    if (promised != std::int64_t{found}) {
      refuse_checksum(mesh_file::elements);
    }
    require_numbers(mesh_file::elements, rows.nodes, static_cast<std::size_t>(node_count));
  });
  const std::string hash = hash_of(outline, element_count * width, rows.nodes, communicator);
  read_together(body, communicator, [&] {
    if (rank == 0) {
      require_hash(hash, outline.hash);
    }
  });
  return rows;
}

}  // namespace idiophone::mesh
