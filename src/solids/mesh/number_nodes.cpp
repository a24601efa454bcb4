#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "idiophone/foundation/each_once.hpp"
#include "neighbourhood.hpp"

namespace idiophone::mesh {

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
