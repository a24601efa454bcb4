#pragma once
// How bodies deform, by the gauges of a deck, at the motion rate.

#include <mpi.h>

#include <cstdint>
#include <span>
#include <vector>

#include "idiophone/run/bodies/motion_rate_channels.hpp"
#include "idiophone/run/bodies/preparation.hpp"
#include "idiophone/solids/motion/motion.hpp"

namespace idiophone::bodies {

/// What a gauge measures: the numbers of one row of its channel.
/// - distance: |b - a|, m.
/// - strain: |b - a|/L - 1, L the distance in the undeformed body.
/// - angle: between a - b and c - b, from 0 to pi, rad.
/// - curvature: of the circle through the points, as a vector from b to its centre, 1/m: with u = a - b and v = c - b,
///   2 (|u|^2 v - |v|^2 u) x (u x v)/(|u|^2 |v|^2 |u - v|^2). Zero on a straight line, and where two points meet.
/// @param points     [Gauge::points] where they are now, m
/// @param reference  likewise in the undeformed bodies
[[nodiscard]] std::vector<double> measured(scene::Gauge::Quantity quantity, std::span<const Vector3> points,
                                           std::span<const Vector3> reference);

class GaugeChannels : public MotionRateChannels {
 public:
  /// Collective.
  /// @param ready, motion  must outlive this object
  GaugeChannels(const Preparation& ready, motion::Motion& motion, MPI_Comm communicator);

  [[nodiscard]] std::vector<std::vector<double>> collect() override;

 private:
  void note_row() override;
  /// The points of a gauge.
  struct Points {
    scene::Gauge::Quantity quantity;
    std::vector<mesh::Patch> patches;  ///< [points] owned nodes, local numbers
    std::vector<Vector3> undeformed;   ///< [points] on rank 0, m
  };
  template <class Place>
  void note_places(const Place& place);
  template <class Take>
  void take_places(const Take& take);

  motion::Motion& motion_;
  std::span<const Vector3> reference_;  ///< [local nodes] m
  MPI_Comm communicator_;
  std::vector<Points> gauges_;
  std::vector<std::int64_t> words_;  ///< [rows][gauges][points][components] of reproducible sums
};

}  // namespace idiophone::bodies
