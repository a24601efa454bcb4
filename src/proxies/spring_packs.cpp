#include "spring_packs.hpp"

#include <algorithm>
#include <cmath>

namespace idiophone::proxies {

namespace {

constexpr std::size_t open_packs = 16;  // that a spring may still join; more would scatter neighbours over memory

/// The sums of four rows.
RowLanes sums(const std::array<RowLanes, lane_count>& rows) {
  const RowLanes pairs01 =
      __builtin_shufflevector(rows[0], rows[1], 0, 4, 2, 6) + __builtin_shufflevector(rows[0], rows[1], 1, 5, 3, 7);
  const RowLanes pairs23 =
      __builtin_shufflevector(rows[2], rows[3], 0, 4, 2, 6) + __builtin_shufflevector(rows[2], rows[3], 1, 5, 3, 7);
  return __builtin_shufflevector(pairs01, pairs23, 0, 1, 4, 5) + __builtin_shufflevector(pairs01, pairs23, 2, 3, 6, 7);
}

/// Springs of a pack that is being filled.
using Group = std::vector<Spring>;

bool touches(const Group& group, const Spring& spring) {
  return std::ranges::any_of(group, [&](const Spring& other) {
    return other.a == spring.a || other.a == spring.b || other.b == spring.a || other.b == spring.b;
  });
}

/// Each spring goes to the first group of the last few that it fits in.
std::vector<Group> groups_of(const std::vector<Spring>& springs) {
  std::vector<Group> groups;
  for (const Spring& spring : springs) {
    const std::size_t first = groups.size() > open_packs ? groups.size() - open_packs : 0;
    const auto found =
        std::find_if(groups.begin() + static_cast<std::ptrdiff_t>(first), groups.end(),
                     [&](const Group& group) { return group.size() < pack_size && !touches(group, spring); });
    (found == groups.end() ? groups.emplace_back() : *found).push_back(spring);
  }
  return groups;
}

SpringPack pack_of(const Group& group, const std::vector<Vector3>& nodes) {
  SpringPack pack;
  for (std::size_t i = 0; i < group.size(); ++i) {
    const Spring& spring = group[i];
    pack.a[i] = spring.a;
    pack.b[i] = spring.b;
    pack.direction[i] = row_of(std::sqrt(spring.stiffness) * (nodes[spring.b] - nodes[spring.a]).normalized());
  }
  return pack;
}

}  // namespace

SpringPacks::SpringPacks(const Lattice& lattice) {
  for (const Group& group : groups_of(lattice.springs())) {
    packs_.push_back(pack_of(group, lattice.mesh().nodes));
  }
}

void SpringPacks::add_forces(const Rows& displacement, Rows& force) const {
  for (const SpringPack& pack : packs_) {
    for (std::size_t first = 0; first < pack_size; first += lane_count) {
      std::array<RowLanes, lane_count> products;
      for (std::size_t i = 0; i < lane_count; ++i) {
        const std::size_t spring = first + i;
        products[i] =
            pack.direction[spring].lanes * (displacement[pack.b[spring]].lanes - displacement[pack.a[spring]].lanes);
      }
      const RowLanes tension = sums(products);
      for (std::size_t i = 0; i < lane_count; ++i) {
        const std::size_t spring = first + i;
        const RowLanes along = tension[i] * pack.direction[spring].lanes;
        force[pack.a[spring]].lanes += along;
        force[pack.b[spring]].lanes -= along;
      }
    }
  }
}

}  // namespace idiophone::proxies
