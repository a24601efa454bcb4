#include "region_reader.hpp"

#include <numeric>

#include "element_group_reader.hpp"
#include "element_reader.hpp"
#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/foundation/parallel/reduce.hpp"
#include "regions_by_group.hpp"
#include "together.hpp"

namespace idiophone::mesh {

void read_regions(const scene::Body& body, Index element_count, ElementRows& rows, MPI_Comm communicator) {
  GmshMesh loaded;  // without nodes
  loaded.element_groups = read_element_groups(body, element_count, communicator);
  if (body.regions.empty()) {
    return;
  }
  loaded.element_tags.resize(rows.nodes.size() / static_cast<std::size_t>(element::node_count(body.element)));
  std::iota(loaded.element_tags.begin(), loaded.element_tags.end(), static_cast<std::size_t>(rows.begin));
  check_together(communicator, [&] { rows.regions = found_regions(body, loaded); });
  rows.region_counts = region_counts(body, rows.regions);
  parallel::reduce(rows.region_counts, MPI_SUM, communicator);
  check_together(communicator, [&] { require_regions(body, loaded, rows.regions, rows.region_counts); });
  rows.region_counts.pop_back();
}

}  // namespace idiophone::mesh
