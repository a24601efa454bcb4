#pragma once
// The springs of a lattice in packs of eight that share no mass, so that no spring waits for the sum of the one before.
// Forces are added in the order of the packs, always the same.

#include <array>
#include <span>
#include <vector>

#include "idiophone/lanes.hpp"
#include "idiophone/proxies/lattice.hpp"

namespace idiophone::proxies {

/// x, y, z and a zero: a vector of one mass, or of one spring.
struct Row {
  Lanes4 lanes{};
};

[[nodiscard]] inline Row row_of(const Vector3& vector) {
  return {Lanes4{vector[0], vector[1], vector[2], 0.0}};
}

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
  void add_forces(std::span<const Row> displacement, std::span<Row> force) const;

 private:
  std::vector<SpringPack> packs_;
};

}  // namespace idiophone::proxies
