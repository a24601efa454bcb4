#pragma once
// Contacts that feel the vibration of the bodies that they touch.

#include <cstdint>
#include <vector>

#include "idiophone/instruments/resonators/mode_group.hpp"

namespace idiophone::resonators {

/// How a player wants a contact to be.
struct ContactMotion {
  double speed = 0.0;  ///< along the surface, m/s
  double load = 0.0;   ///< N
};

/// What touches a body at one point, or two bodies that touch each other. Its force is constant over an audio sample.
/// Then the force times the way of the point is exactly the work that the modes get. The way of two bodies is the sum
/// of the ways of their points, each along the force on its own body.
class Contact {
 public:
  Contact() = default;
  virtual ~Contact() = default;
  Contact(const Contact&) = delete;
  Contact(Contact&&) = delete;
  Contact& operator=(const Contact&) = delete;
  Contact& operator=(Contact&&) = delete;

  /// On the body in the next audio sample, N, if the point goes `free + compliance force`. Realtime-safe.
  /// @param free        way of the point in the sample without this force, m
  /// @param compliance  m/N; not negative
  [[nodiscard]] virtual double force(double free, double compliance) const = 0;

  /// The sample is over. Realtime-safe.
  /// @param way    of the point, m
  /// @param force  that it had, N
  virtual void advance(double way, double force) = 0;

  /// From now on a player leads it, if anybody can. Realtime-safe.
  /// @param samples  in which the motion is reached, evenly
  virtual void lead(const ContactMotion& /*motion*/, std::int64_t /*samples*/) {}

  /// Whether it has left the body for good. Realtime-safe.
  [[nodiscard]] virtual bool is_over() const { return false; }
};

/// A point of a body and a direction, as its modes have them.
struct ContactPoint {
  std::vector<ModeGroup> displacement;  ///< [groups] Re(displacement z) summed over the modes, m
  std::vector<ModeGroup> by_mean;       ///< [groups] as in Drive
  std::vector<ModeGroup> by_slope;      ///< [groups] zero, because the force has no slope
  double lowest = 0.0;                  ///< angular frequency of the lowest mode, rad/s; above 0
};

}  // namespace idiophone::resonators
