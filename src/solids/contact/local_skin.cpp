#include "local_skin.hpp"

#include <algorithm>
#include <utility>

namespace idiophone::contact {

namespace {

/// Local number of each node of a skin; -1 where this rank does not have it.
std::vector<Index> local_numbers(const Skin& skin, const mesh::Part& part) {
  std::vector<std::pair<Index, Index>> local;  // global number, local number
  for (std::size_t node = 0; node < part.node_ids.size(); ++node) {
    local.emplace_back(part.node_ids[node], static_cast<Index>(node));
  }
  std::ranges::sort(local);
  std::vector<Index> numbers(skin.nodes.size(), -1);
  for (std::size_t place = 0; place < skin.nodes.size(); ++place) {
    const auto found = std::ranges::lower_bound(local, skin.nodes[place], {}, &std::pair<Index, Index>::first);
    if (found != local.end() && found->first == skin.nodes[place]) {
      numbers[place] = found->second;
    }
  }
  return numbers;
}

}  // namespace

LocalSkin find_local_skin(const Skin& skin, const mesh::Part& part) {
  const std::vector<Index> numbers = local_numbers(skin, part);
  const auto owned = [&](Index place) { return numbers[place] >= 0 && numbers[place] < part.owned_nodes; };
  LocalSkin local;
  std::vector<char> here(skin.nodes.size());
  for (std::size_t cell = 0; cell < skin.cells.size(); ++cell) {
    if (std::ranges::any_of(skin.cells[cell], owned)) {
      local.cells.push_back(static_cast<Index>(cell));
      for (const Index place : skin.cells[cell]) {
        here[place] = 1;
      }
    }
  }
  for (Index place = 0; place < std::ssize(here); ++place) {
    if (here[place] == 0) {
      continue;
    }
    local.nodes.push_back({place, numbers[place]});
    if (owned(place)) {
      local.owned.push_back({place, numbers[place]});
    }
  }
  return local;
}

}  // namespace idiophone::contact
