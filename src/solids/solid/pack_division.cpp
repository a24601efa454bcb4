#include "idiophone/solids/solid/pack_division.hpp"

#include <algorithm>
#include <numeric>

namespace idiophone::solid {

namespace {

bool is_ghost(const mesh::BodyPart& part, Index node) {
  return node < part.owned_begin || node >= part.owned_end;
}

/// Calls visit(pack, place in the pack's table of [nodes of an element x lanes], node) for each element in ascending
/// order.
template <class Visitor>
void for_each_node_of_packs(const mesh::BodyPart& part, const PackLayout& layout, Visitor visit) {
  for (std::size_t pack = 0; pack < layout.pack_count(); ++pack) {
    for (int lane = 0; lane < layout.filled_lanes(pack); ++lane) {
      const auto place = static_cast<std::size_t>(lane);
      const std::span<const Index> nodes = part.element_nodes(layout.first_element(pack) + place);
      for (std::size_t a = 0; a < nodes.size(); ++a) {
        visit(pack, a * lanes + place, nodes[a]);
      }
    }
  }
}

std::vector<bool> packs_with_ghosts(const mesh::BodyPart& part, const PackLayout& layout) {
  std::vector<bool> found(layout.pack_count());
  for_each_node_of_packs(part, layout, [&](std::size_t pack, std::size_t /*place*/, Index node) {
    found[pack] = found[pack] || is_ghost(part, node);
  });
  return found;
}

}  // namespace

HeldForces::HeldForces(const mesh::BodyPart& part, const PackLayout& layout, const std::vector<bool>& needs_ghosts)
    : first_(needs_ghosts.size(), at_once) {
  const auto width = static_cast<std::size_t>(element::node_count(part.element)) * lanes;
  const Index last = part.elements.empty() ? -1 : std::ranges::max(part.elements);
  std::vector<bool> waits(last + 1);  // an element of a late pack comes before those that follow
  std::vector<bool> holds(last + 1);  // so does a force that is held
  std::vector<std::size_t> places;    // [slots] in slots_, in ascending order of elements
  for_each_node_of_packs(part, layout, [&](std::size_t pack, std::size_t place, Index node) {
    if (is_ghost(part, node)) {
      return;
    }
    holds[node] = holds[node] || (waits[node] && !needs_ghosts[pack]);
    waits[node] = waits[node] || needs_ghosts[pack];
    if (holds[node]) {
      if (first_[pack] == at_once) {
        first_[pack] = static_cast<Index>(slots_.size());
        slots_.resize(slots_.size() + width, at_once);
      }
      places.push_back(first_[pack] + place);
      nodes_.push_back(node);
    }
  });
  std::vector<std::size_t> order(places.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return nodes_[i]; });
  for (std::size_t slot = 0; slot < order.size(); ++slot) {
    slots_[places[order[slot]]] = static_cast<Index>(slot);
  }
  std::ranges::sort(nodes_);
  forces_.resize(nodes_.size());
}

void HeldForces::add(std::span<NodeForce> force) const {
  for (std::size_t slot = 0; slot < forces_.size(); ++slot) {
    for (int i = 0; i < 3; ++i) {
      force[nodes_[slot]].component[i] += forces_[slot].component[i];
    }
  }
}

PackDivision PackDivision::by_ghosts(const mesh::BodyPart& part) {
  const PackLayout layout(part);
  const std::vector<bool> needs_ghosts = packs_with_ghosts(part, layout);
  PackDivision division{.inner = {}, .border = {}, .held = HeldForces(part, layout, needs_ghosts)};
  for (std::size_t pack = 0; pack < needs_ghosts.size(); ++pack) {
    auto& ranges = needs_ghosts[pack] ? division.border : division.inner;
    if (ranges.empty() || ranges.back().end != pack) {
      ranges.push_back({pack, pack});
    }
    ++ranges.back().end;
  }
  return division;
}

}  // namespace idiophone::solid
