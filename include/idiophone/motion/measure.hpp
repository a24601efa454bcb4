#pragma once
// What is known of a body's motion at one moment, as sums that come out the same to the bit on any number of ranks.

#include <array>
#include <vector>

#include "idiophone/motion/motion.hpp"
#include "idiophone/reproducible_sum.hpp"

namespace idiophone::motion {

/// This rank's share of one body's sums over nodes and elements; merge the ranks' for the whole.
struct BodySums {
  std::array<ReproducibleSum, 3> position;          ///< mass times position, kg m
  std::array<ReproducibleSum, 3> momentum;          ///< kg m/s
  std::array<ReproducibleSum, 3> angular_momentum;  ///< about the origin, kg m2/s
  ReproducibleSum kinetic;                          ///< energy, J
  ReproducibleSum elastic;                          ///< energy, J

  /// All of them in one order, for sending and for files.
  static constexpr std::size_t count = 11;
  [[nodiscard]] std::array<ReproducibleSum, count> all() const;
};

/// Measures every body now; costs one force evaluation and changes nothing in the motion. No communication.
/// @return [bodies]
[[nodiscard]] std::vector<BodySums> measure(Motion& motion, const mesh::Part& part);

}  // namespace idiophone::motion
