#pragma once
// Air that the bodies' surfaces move, and that acts on them.

#include <span>
#include <vector>

#include "idiophone/foundation/types.hpp"

namespace idiophone::propagation {

/// Is advanced together with the bodies, in steps of which a whole number make an audio sample.
class AirLoad {
 public:
  AirLoad() = default;
  virtual ~AirLoad() = default;
  AirLoad(const AirLoad&) = delete;
  AirLoad& operator=(const AirLoad&) = delete;
  AirLoad(AirLoad&&) = delete;
  AirLoad& operator=(AirLoad&&) = delete;

  /// In an audio sample.
  [[nodiscard]] virtual int steps() const = 0;

  /// Says for which triangles this rank needs the force. Once, before the air begins. Collective.
  /// @param triangles  global numbers, ascending; several ranks may need the same
  virtual void connect(const std::vector<Index>& triangles) = 0;

  /// One step, in which surfaces moved with given mean velocities, linear on each triangle. Waits for ranks whose
  /// surfaces are near.
  /// @param changes     [connected triangles x 3 corners] of the normal velocity at the corner since the step before,
  ///                    outwards, m/s
  /// @param force       [connected triangles x 3 corners] N, overwritten: the integral of the pressure times the
  ///                    corner's linear shape function, mean over the next step if velocities stay as they are; it acts
  ///                    inwards
  /// @param resistance  [connected triangles x 3 corners] N s/m, overwritten: by how much the force grows with the
  ///                    corner's velocity
  virtual void advance(std::span<const double> changes, std::span<double> force, std::span<double> resistance) = 0;
};

}  // namespace idiophone::propagation
