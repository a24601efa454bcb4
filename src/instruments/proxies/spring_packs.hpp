#pragma once
// The springs of a lattice in packs of four that begin at the same mass: its displacement is read, and its force is
// written, once for a pack. Forces are added in the order of the packs, always the same.

#include <array>
#include <span>
#include <vector>

#include "idiophone/instruments/proxies/lattice.hpp"
#include "spring_rows.hpp"

namespace idiophone::proxies {

inline constexpr std::size_t springs_in_pack = lane_count;

struct SpringPack {
  std::array<Row, springs_in_pack> direction{};  ///< unit vector from a to b, times sqrt(stiffness), sqrt(N/m)
  std::array<Index, springs_in_pack> b{};        ///< masses; what is missing in a pack has a zero direction
  Index a = 0;                                   ///< the mass that all of them begin at
};

/// What a spring under tension at rest adds in all directions.
struct RestTension {
  Index a = 0, b = 0;
  float stiffness = 0.0F;  ///< tension over length, N/m; negative if it is pressed
};

class SpringPacks {
 public:
  explicit SpringPacks(const Lattice& lattice);
  SpringPacks(std::span<const Vector3> nodes, std::span<const Spring> springs);

  /// In which there are all forces to compute.
  [[nodiscard]] std::size_t packs() const { return packs_.size() + padded_rows(tensions_.size()) / springs_in_pack; }

  /// Adds the springs' forces, for displacements that are small compared with the lengths: k n (n . (u_b - u_a)) on a,
  /// and its opposite on b (O'Morain 2005, eq. 6.1, linear in u). A tension T at rest adds T/l (u_b - u_a) across n.
  /// @param displacement  [masses] m
  /// @param force         [masses] N
  void add_forces(const Rows& displacement, Rows& force) const;

 private:
  std::vector<SpringPack> packs_;
  std::vector<RestTension> tensions_;
};

}  // namespace idiophone::proxies
