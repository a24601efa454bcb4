#include "spring_packs.hpp"

#include <cmath>
#include <span>

namespace idiophone::proxies {

namespace {

/// The sums of four rows.
RowLanes sums(const std::array<RowLanes, lane_count>& rows) {
  const RowLanes pairs01 =
      __builtin_shufflevector(rows[0], rows[1], 0, 4, 2, 6) + __builtin_shufflevector(rows[0], rows[1], 1, 5, 3, 7);
  const RowLanes pairs23 =
      __builtin_shufflevector(rows[2], rows[3], 0, 4, 2, 6) + __builtin_shufflevector(rows[2], rows[3], 1, 5, 3, 7);
  return __builtin_shufflevector(pairs01, pairs23, 0, 1, 4, 5) + __builtin_shufflevector(pairs01, pairs23, 2, 3, 6, 7);
}

/// Which springs begin at each mass. A spring may begin at either end: each mass takes those that no mass before it has
/// taken, as many as fill packs, and leaves the others to the masses after it.
std::vector<std::vector<Spring>> springs_from(std::size_t masses, std::span<const Spring> all_springs) {
  std::vector<std::vector<Spring>> later(masses);   // to masses with greater numbers
  std::vector<std::vector<Spring>> chosen(masses);  // at first those that masses with smaller numbers left
  for (const Spring& spring : all_springs) {
    later[spring.a].push_back(spring);
  }
  for (std::size_t mass = 0; mass < masses; ++mass) {
    const std::size_t left = chosen[mass].size(), all = left + later[mass].size();
    const std::size_t full = all / springs_in_pack * springs_in_pack;
    const auto taken = static_cast<std::ptrdiff_t>((full < left ? all : full) - left);
    chosen[mass].insert(chosen[mass].end(), later[mass].begin(), later[mass].begin() + taken);
    for (const Spring& spring : std::span(later[mass]).subspan(static_cast<std::size_t>(taken))) {
      chosen[spring.b].push_back({.a = spring.b, .b = spring.a, .stiffness = spring.stiffness});
    }
  }
  return chosen;
}

}  // namespace

SpringPacks::SpringPacks(const Lattice& lattice) : SpringPacks(lattice.mesh().nodes, lattice.springs()) {}

SpringPacks::SpringPacks(std::span<const Vector3> nodes, std::span<const Spring> all) {
  std::vector<Spring> along(all.begin(), all.end());  // k n n^T + T/l (1 - n n^T) = (k - T/l) n n^T + T/l
  for (Spring& spring : along) {
    if (const double across = spring.tension / (nodes[spring.b] - nodes[spring.a]).norm(); across != 0.0) {
      spring.stiffness -= across;
      tensions_.push_back({.a = spring.a, .b = spring.b, .stiffness = static_cast<float>(across)});
    }
  }
  for (const std::vector<Spring>& springs : springs_from(nodes.size(), along)) {
    for (std::size_t i = 0; i < springs.size(); ++i) {
      const Spring& spring = springs[i];
      SpringPack& pack = i % springs_in_pack == 0 ? packs_.emplace_back() : packs_.back();
      pack.a = spring.a;
      pack.b[i % springs_in_pack] = spring.b;
      pack.direction[i % springs_in_pack] =
          row_of(std::sqrt(spring.stiffness) * (nodes[spring.b] - nodes[spring.a]).normalized());
    }
  }
}

void SpringPacks::add_forces(const Rows& displacement, Rows& force) const {
  for (const SpringPack& pack : packs_) {
    const RowLanes from = displacement[pack.a].lanes;
    std::array<RowLanes, springs_in_pack> direction, products;
    for (std::size_t i = 0; i < springs_in_pack; ++i) {
      direction[i] = pack.direction[i].lanes;
      products[i] = direction[i] * (displacement[pack.b[i]].lanes - from);
    }
    const RowLanes tension = sums(products);
    RowLanes sum{};
    for (std::size_t i = 0; i < springs_in_pack; ++i) {
      const RowLanes along = tension[i] * direction[i];
      sum += along;
      force[pack.b[i]].lanes -= along;
    }
    force[pack.a].lanes += sum;
  }
  for (const RestTension& tension : tensions_) {
    const RowLanes pull = tension.stiffness * (displacement[tension.b].lanes - displacement[tension.a].lanes);
    force[tension.a].lanes += pull;
    force[tension.b].lanes -= pull;
  }
}

}  // namespace idiophone::proxies
