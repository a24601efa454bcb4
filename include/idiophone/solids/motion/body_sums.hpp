#pragma once
// A body's motion at one moment, as sums that come out the same to the bit on any number of ranks.

#include <algorithm>
#include <array>

#include "idiophone/foundation/parallel/reproducible_sum.hpp"
#include "idiophone/foundation/types.hpp"

namespace idiophone::motion {

struct InitialState;

/// The units in which a body's sums are kept: exact powers of two, so that terms of bodies of any size fit the sums.
/// A length unit is some thousand times the body's size: the sums then hold the body's own moments to one part in 2^50
/// and leave it room to travel a million times its size.
struct BodyUnits {
  double mass;    ///< kg
  double length;  ///< m

  BodyUnits(const InitialState& initial_state, std::size_t body);
};

/// This rank's share of the sums over nodes and elements of one body, or of one of its pieces; merge the ranks' for the
/// whole. Masses and lengths are in the BodyUnits of the body, times in s. u is a node's displacement, v its velocity,
/// X - C its reference position from the undeformed body's centre of mass.
struct BodySums {
  std::array<ReproducibleSum, 3> displacement;      ///< sum of m u, length units
  std::array<ReproducibleSum, 3> momentum;          ///< sum of m v, v in m/s
  std::array<ReproducibleSum, 3> angular_momentum;  ///< sum of m (X + u - C) x v about C, length units and v in m/s
  std::array<ReproducibleSum, 9> cross_moment;      ///< sum of m u (X - C)^T, column by column, length units^2
  std::array<ReproducibleSum, 6> second_moment;     ///< sum of m u u^T, length units^2: xx, xy, yy, xz, yz, zz
  std::array<ReproducibleSum, 6> added_moment;      ///< that of the added mass, mass and length units, likewise
  ReproducibleSum kinetic;                          ///< energy, v in m/s
  ReproducibleSum elastic;                          ///< energy, J per mass unit

  static constexpr std::size_t count = 32;

  /// Calls `visit` with every sum, in one order: for sending and receiving.
  /// @param sums  BodySums, const or not
  template <class Sums, class Visitor>
  static void for_each(Sums& sums, Visitor visit) {
    std::ranges::for_each(sums.displacement, visit);
    std::ranges::for_each(sums.momentum, visit);
    std::ranges::for_each(sums.angular_momentum, visit);
    std::ranges::for_each(sums.cross_moment, visit);
    std::ranges::for_each(sums.second_moment, visit);
    std::ranges::for_each(sums.added_moment, visit);
    visit(sums.kinetic);
    visit(sums.elastic);
  }

  /// Adds the sums of another part of the same body.
  void merge(const BodySums& other);
};

/// Adds the terms of a vector.
void add(std::array<ReproducibleSum, 3>& sums, const Vector3& terms);
/// Adds those of a matrix, column by column.
void add(std::array<ReproducibleSum, 9>& sums, const Eigen::Matrix3d& terms);
/// Adds those of a symmetric matrix: xx, xy, yy, xz, yz, zz.
void add(std::array<ReproducibleSum, 6>& sums, const Eigen::Matrix3d& terms);

}  // namespace idiophone::motion
