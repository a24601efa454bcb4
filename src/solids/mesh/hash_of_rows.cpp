#include "hash_of_rows.hpp"

#include "hash.hpp"
#include "idiophone/foundation/parallel/broadcast.hpp"
#include "idiophone/foundation/parallel/communicator.hpp"

namespace idiophone::mesh {

namespace {

void add_elements(const ElementRows& rows, std::size_t width, Index region, Fnv1a& hash) {
  if (rows.region_counts.empty()) {
    hash.add_bytes(std::as_bytes(std::span(rows.nodes)));
    return;
  }
  for (std::size_t place = 0; place < rows.regions.size(); ++place) {
    if (rows.regions[place] == region) {
      hash.add_bytes(std::as_bytes(std::span(rows.nodes).subspan(place * width, width)));
    }
  }
}

/// As Mesh::regions, without the length.
void add_regions(const std::vector<Index>& counts, Fnv1a& hash) {
  for (Index region = 0; region < std::ssize(counts); ++region) {
    for (Index element = 0; element < counts[region]; ++element) {
      hash.add_bytes(std::as_bytes(std::span(&region, 1)));
    }
  }
}

}  // namespace

/// The ranks take in their elements one after another.
std::string hash_of_rows(const Mesh& outline, const ElementRows& rows, Index element_count, MPI_Comm communicator) {
  const int rank = parallel::rank_of(communicator), ranks = parallel::size_of(communicator);
  const auto width = static_cast<std::size_t>(parallel::from_root(element::node_count(outline.element), communicator));
  Fnv1a hash;
  if (rank == 0) {
    add_nodes(outline, hash);
    hash.add_length(width * static_cast<std::size_t>(element_count));
  }
  const Index regions = rows.region_counts.empty() ? 1 : static_cast<Index>(rows.region_counts.size());
  int last = 0;
  for (Index region = 0; region < regions; ++region) {
    for (int adder = 0; adder < ranks; last = adder++) {
      parallel::broadcast(hash, communicator, last);
      if (adder == rank) {
        add_elements(rows, width, region, hash);
      }
    }
  }
  parallel::broadcast(hash, communicator, last);
  add_surface_and_groups(outline, hash);
  if (!rows.region_counts.empty()) {
    hash.add_length(static_cast<std::uint64_t>(element_count));
    add_regions(rows.region_counts, hash);
  }
  return parallel::from_root(hash.text(), communicator);
}

}  // namespace idiophone::mesh
