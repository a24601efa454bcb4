#pragma once
// The springs of a lattice in packs of eight that share no mass, so that no spring waits for the sum of the one before.
// Forces are added in the order of the packs, always the same.

#include <array>
#include <vector>

#include "idiophone/proxies/lattice.hpp"
#include "rows.hpp"

namespace idiophone::proxies {

struct SpringPack {
  std::array<Row, pack_size> direction{};  ///< unit vector from a to b, times sqrt(stiffness), sqrt(N/m)
  std::array<Index, pack_size> a{}, b{};   ///< masses; what is missing in a pack has a zero direction
};

class SpringPacks {
 public:
  explicit SpringPacks(const Lattice& lattice);

  [[nodiscard]] std::size_t packs() const { return packs_.size(); }

  /// Adds the springs' forces, for displacements that are small compared with the lengths: k n (n . (u_b - u_a)) on a,
  /// and its opposite on b (O'Morain 2005, eq. 6.1, linear in u).
  /// @param displacement  [masses] m
  /// @param force         [masses] N
  void add_forces(const Rows& displacement, Rows& force) const;

 private:
  std::vector<SpringPack> packs_;
};

}  // namespace idiophone::proxies
