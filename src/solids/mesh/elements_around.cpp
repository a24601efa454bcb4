#include <algorithm>
#include <numeric>
#include <utility>

#include "compressed_rows.hpp"
#include "idiophone/foundation/each_once.hpp"
#include "idiophone/foundation/parallel/broadcast.hpp"
#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/foundation/parallel/exchange.hpp"
#include "neighbourhood.hpp"

namespace idiophone::mesh {

namespace {

/// The numbers of an element.
struct ElementNumbers {
  Index in_body;  ///< region by region
  Index in_file;
};

/// [regions + 1] The number of the first element of each.
std::vector<Index> region_begins(const std::vector<Index>& counts) {
  std::vector<Index> begins(counts.size() + 1);
  std::partial_sum(counts.begin(), counts.end(), begins.begin() + 1);
  return begins;
}

/// Of this process's rows, in the body. Collective.
std::vector<Index> numbers_of(const ElementRows& rows, std::size_t elements, MPI_Comm communicator) {
  std::vector<Index> numbers(elements);
  if (rows.region_counts.empty()) {
    std::iota(numbers.begin(), numbers.end(), rows.begin);
    return numbers;
  }
  std::vector<Index> own(rows.region_counts.size());
  std::ranges::for_each(rows.regions, [&](Index region) { ++own[region]; });
  const auto counts = parallel::gather_all<Index>(own, communicator);
  std::vector<Index> next = region_begins(rows.region_counts);
  for (int i = 0; i < counts.offsets[parallel::rank_of(communicator)]; ++i) {  // of the processes before
    next[static_cast<std::size_t>(i) % own.size()] += counts.values[i];
  }
  std::ranges::transform(rows.regions, numbers.begin(), [&](Index region) { return next[region]++; });
  return numbers;
}

/// The processes that compute each element, as lists of places in the rows.
CompressedRows takers_of(const ElementRows& rows, std::size_t width, Index first_node, const NodeDivision& division) {
  return {division.processes(), [&](auto take) {
            std::vector<int> owners;
            for (std::size_t place = 0; place * width < rows.nodes.size(); ++place) {
              owners.clear();
              for (const Index node : std::span(rows.nodes).subspan(place * width, width)) {
                owners.push_back(division.process_of(first_node + node));
              }
              keep_each_once(owners);
              std::ranges::for_each(owners, [&](int process) { take(process, static_cast<Index>(place)); });
            }
          }};
}

/// Puts elements of several materials in order; others come in order.
/// @param counts   [regions] over all processes
/// @param numbers  [elements]
void order_by_region(const std::vector<Index>& counts, std::vector<ElementNumbers>& numbers, Mesh& mesh) {
  const std::vector<Index> begins = region_begins(counts);
  std::vector<Index> order(numbers.size()), nodes;
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, {}, [&](Index element) { return numbers[element].in_body; });
  for (const Index element : order) {
    std::ranges::copy(mesh.element_nodes(element), std::back_inserter(nodes));
    const auto after = std::ranges::upper_bound(begins, numbers[element].in_body);
    mesh.regions.push_back(static_cast<Index>(after - begins.begin()) - 1);
  }
  mesh.elements = std::move(nodes);
  std::ranges::sort(numbers, {}, &ElementNumbers::in_body);
}

/// Elements on their way to other processes.
struct Parcel {
  std::vector<int> counts;              ///< [processes] elements for each
  std::vector<ElementNumbers> numbers;  ///< [elements] process by process
  std::vector<Index> nodes;             ///< [nodes per element x elements] likewise, numbers in the body
};

/// Collective.
/// @param takers  [processes] places in the rows
Parcel pack(const ElementRows& rows, std::size_t width, const CompressedRows& takers, MPI_Comm communicator) {
  const std::vector<Index> own = numbers_of(rows, rows.nodes.size() / width, communicator);
  Parcel parcel;
  for (int process = 0; process < parallel::size_of(communicator); ++process) {
    parcel.counts.push_back(static_cast<int>(takers[process].size()));
    for (const Index place : takers[process]) {
      parcel.numbers.push_back({own[place], rows.begin + place});
      std::ranges::copy(std::span(rows.nodes).subspan(static_cast<std::size_t>(place) * width, width),
                        std::back_inserter(parcel.nodes));
    }
  }
  return parcel;
}

/// What this process takes of all parcels. Collective.
/// @param region_counts  as ElementRows has them
Neighbourhood take(const Parcel& parcel, const scene::Body& body, const std::vector<Index>& region_counts,
                   MPI_Comm communicator) {
  const auto width = static_cast<std::size_t>(element::node_count(body.element));
  Neighbourhood result;
  Mesh& mesh = result.loaded.mesh;
  mesh.element = body.element;
  mesh.elements = parallel::exchange<Index>(parcel.nodes, parcel.counts, communicator, width);
  auto numbers = parallel::exchange<ElementNumbers>(parcel.numbers, parcel.counts, communicator);
  if (!region_counts.empty()) {
    order_by_region(region_counts, numbers, mesh);
  }
  for (const auto& [in_body, in_file] : numbers) {
    result.numbers.push_back(in_body);
    result.loaded.element_tags.push_back(static_cast<std::size_t>(in_file));
  }
  return result;
}

}  // namespace

Neighbourhood elements_around(ElementRows rows, const scene::Body& body, Index first_node, const NodeDivision& division,
                              MPI_Comm communicator) {
  const auto width = static_cast<std::size_t>(element::node_count(body.element));
  const Parcel parcel = pack(rows, width, takers_of(rows, width, first_node, division), communicator);
  rows.nodes = std::vector<Index>();  // frees its memory, which {} does not
  return take(parcel, body, rows.region_counts, communicator);
}

void give_root_elements(const ElementRows& rows, const scene::Body& body, std::vector<Index> nodes, Mesh& outline,
                        MPI_Comm communicator) {
  parallel::broadcast(nodes, communicator);
  if (nodes.empty()) {
    return;
  }
  const auto width = static_cast<std::size_t>(element::node_count(body.element));
  const CompressedRows takers(parallel::size_of(communicator), [&](auto give) {
    for (std::size_t place = 0; place * width < rows.nodes.size(); ++place) {
      if (std::ranges::any_of(std::span(rows.nodes).subspan(place * width, width),
                              [&](Index node) { return std::ranges::binary_search(nodes, node); })) {
        give(0, static_cast<Index>(place));
      }
    }
  });
  Mesh taken = take(pack(rows, width, takers, communicator), body, rows.region_counts, communicator).loaded.mesh;
  outline.elements = std::move(taken.elements);
  outline.regions = std::move(taken.regions);
}

}  // namespace idiophone::mesh
