#include "neighbourhood.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "compressed_rows.hpp"
#include "curve_division.hpp"
#include "idiophone/foundation/each_once.hpp"
#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/foundation/parallel/exchange.hpp"

namespace idiophone::mesh {

GmshMesh elements_around(ElementRows rows, const scene::Body& body, Index first_node, const std::vector<Index>& first,
                         MPI_Comm communicator) {
  const auto width = static_cast<std::size_t>(element::node_count(body.element));
  const auto elements = static_cast<Index>(rows.nodes.size() / width);
  const int ranks = parallel::size_of(communicator);
  const auto nodes_of = [&](Index place) { return std::span(rows.nodes).subspan(place * width, width); };
  const CompressedRows takers(ranks, [&](auto take) {
    std::vector<int> owners;
    for (Index place = 0; place < elements; ++place) {
      owners.clear();
      for (const Index node : nodes_of(place)) {
        owners.push_back(owner_of(first_node + node, first));
      }
      keep_each_once(owners);
      std::ranges::for_each(owners, [&](int rank) { take(rank, place); });
    }
  });
  std::vector<int> counts;
  std::vector<Index> numbers, nodes;
  for (int rank = 0; rank < ranks; ++rank) {
    counts.push_back(static_cast<int>(takers[rank].size()));
    for (const Index place : takers[rank]) {
      numbers.push_back(rows.begin + place);
      std::ranges::copy(nodes_of(place), std::back_inserter(nodes));
    }
  }
  rows.nodes = {};
  GmshMesh loaded;
  loaded.mesh.element = body.element;
  loaded.mesh.elements = parallel::exchange<Index>(nodes, counts, communicator, width);
  const std::vector<Index> taken = parallel::exchange<Index>(numbers, counts, communicator);
  loaded.element_tags.assign(taken.begin(), taken.end());
  return loaded;
}

std::string number_nodes(GmshMesh& loaded, Index begin, Index end, std::vector<Index> others) {
  std::vector<char> used(end - begin);
  const auto is_owned = [&](Index node) { return node >= begin && node < end; };
  for (const Index node : loaded.mesh.elements) {
    if (is_owned(node)) {
      used[node - begin] = 1;
    } else {
      others.push_back(node);
    }
  }
  std::erase_if(others, is_owned);
  keep_each_once(others);
  const auto after = std::ranges::lower_bound(others, begin);
  loaded.node_tags.assign(others.begin(), after);
  const auto before = static_cast<Index>(loaded.node_tags.size());
  loaded.node_tags.resize(before + used.size());
  std::iota(loaded.node_tags.begin() + before, loaded.node_tags.end(), static_cast<std::size_t>(begin));
  loaded.node_tags.insert(loaded.node_tags.end(), after, others.end());
  for (Index& node : loaded.mesh.elements) {
    if (is_owned(node)) {
      node += before - begin;
    } else {
      const auto place = static_cast<Index>(std::ranges::lower_bound(others, node) - others.begin());
      node = place + (node < begin ? 0 : end - begin);
    }
  }
  const auto unused = std::ranges::find(used, 0);
  return unused == used.end()
             ? ""
             : fmt::format("has node {}, which no element has: make the file anew with `idiophone mesh`",
                           begin + (unused - used.begin()));
}

}  // namespace idiophone::mesh
