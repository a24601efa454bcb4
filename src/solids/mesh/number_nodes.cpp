#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <utility>

#include "idiophone/foundation/each_once.hpp"
#include "neighbourhood.hpp"

namespace idiophone::mesh {

std::string number_nodes(GmshMesh& loaded, Index begin, Index end, std::span<const Index> away,
                         std::vector<Index> others) {
  std::vector<Index> places(end - begin);  // first 1 where a node of the range is used
  const auto is_in_range = [&](Index node) { return node >= begin && node < end; };
  std::ranges::copy_if(loaded.mesh.elements, std::back_inserter(others), std::not_fn(is_in_range));
  for (const std::vector<Index>* nodes : {&std::as_const(loaded.mesh.elements), &std::as_const(others)}) {
    for (const Index node : *nodes) {
      if (is_in_range(node)) {
        places[node - begin] = 1;
      }
    }
  }
  std::erase_if(others, is_in_range);
  keep_each_once(others);
  const auto after = std::ranges::lower_bound(others, begin);
  loaded.node_tags.assign(others.begin(), after);
  std::string problem;
  for (Index node = begin; node < end; ++node) {
    const bool is_used = places[node - begin] == 1;
    places[node - begin] = static_cast<Index>(loaded.node_tags.size());
    if (is_used) {
      loaded.node_tags.push_back(static_cast<std::size_t>(node));
    } else if (problem.empty() && !std::ranges::binary_search(away, node)) {
      problem = fmt::format("has node {}, which no element has: make the file anew with `idiophone mesh`", node);
    }
  }
  const Index behind = static_cast<Index>(loaded.node_tags.size()) - static_cast<Index>(after - others.begin());
  loaded.node_tags.insert(loaded.node_tags.end(), after, others.end());
  for (Index& node : loaded.mesh.elements) {
    if (is_in_range(node)) {
      node = places[node - begin];
    } else {
      const auto place = static_cast<Index>(std::ranges::lower_bound(others, node) - others.begin());
      node = place + (node < begin ? 0 : behind);
    }
  }
  return problem;
}

}  // namespace idiophone::mesh
