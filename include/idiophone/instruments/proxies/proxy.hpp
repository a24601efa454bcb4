#pragma once
// The vibration of one body as a mass-spring system (O'Morain 2005, chapter 6). The rigid motion belongs to the
// physics: a free proxy takes only that part of a force that deforms it.

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "idiophone/instruments/proxies/integrator.hpp"
#include "idiophone/instruments/proxies/lattice.hpp"

namespace idiophone::proxies {

/// Settings of a proxy.
struct ProxyOptions {
  Integrator integrator = Integrator::symplectic_euler;
  double rate = 44100.0;                ///< of the intervals that advance() takes, Hz
  double significant_distance = 1e-10;  ///< m: a mass that is nearer to its place and moves less may become stable
};

/// A force that is constant in an interval.
struct PointForce {
  Contact contact;
  Vector3 force = Vector3::Zero();  ///< N
};

class Proxy {
 public:
  /// At rest.
  /// @throws std::invalid_argument as stable_steps()
  Proxy(std::shared_ptr<const Lattice> lattice, const ProxyOptions& options);
  ~Proxy();
  Proxy(Proxy&&) noexcept;
  Proxy& operator=(Proxy&&) noexcept;
  Proxy(const Proxy&) = delete;
  Proxy& operator=(const Proxy&) = delete;

  [[nodiscard]] const Lattice& lattice() const;

  /// Goes on by one interval. A stable proxy does nothing unless a force acts. No allocation.
  void advance(std::span<const PointForce> forces);

  /// Whether every mass is stable: nearer to its place than the significant distance in the last five intervals, and
  /// too slow to go as far in an interval (his recent memory, section 6.4). The proxy is then at rest.
  [[nodiscard]] bool is_stable() const;

  /// Stops at once.
  void stop();

  /// Sum over the surface triangles of their deviation from rest along the normal times their area, m3: the volume by
  /// which the body is larger than at rest (section 6.6).
  [[nodiscard]] double deviation() const;

  /// Rate of the volume that the triangles that face a direction sweep, m3/s: what a listener there hears of a body.
  [[nodiscard]] double facing_volume_velocity() const;

  /// The same for the direction that turn_to() has set, or that of face().
  [[nodiscard]] double next_facing_volume_velocity() const;

  /// Chooses the triangles for facing_volume_velocity(). At first all count. No allocation.
  /// @param direction  from the body to the listener, of any length but 0
  void face(const Vector3& direction);

  /// Chooses those for next_facing_volume_velocity(). No allocation. @return whether they are others than those now
  bool turn_to(const Vector3& direction);

  /// From now on facing_volume_velocity() has the triangles of next_facing_volume_velocity(). No allocation.
  void end_turn();

  /// Changes all springs by a factor, and the dampers with them, and the damping: his sliders. What rings goes on. No
  /// allocation. @throws std::invalid_argument as stable_steps(), or for a number out of range
  void tune(double tension, const Damping& damping);

  /// Changes the rate of the intervals, Hz. No allocation. @throws std::invalid_argument as stable_steps()
  void set_rate(double rate);

  [[nodiscard]] int steps() const;  ///< in an interval

  /// Spring forces that are computed in a second of sound.
  [[nodiscard]] double springs_per_second() const;

  [[nodiscard]] double kinetic_energy() const;     ///< J
  [[nodiscard]] double elastic_energy() const;     ///< J
  [[nodiscard]] Vector3 momentum() const;          ///< kg m/s
  [[nodiscard]] Vector3 angular_momentum() const;  ///< about the centre of mass, kg m2/s

  /// Of a mass, m.
  [[nodiscard]] Vector3 velocity(Index mass) const;  ///< m/s
  [[nodiscard]] Vector3 displacement(Index mass) const;

  /// Starts a vibration, with the displacements and velocities of all masses.
  void set_state(std::span<const Vector3> displacement, std::span<const Vector3> velocity);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace idiophone::proxies
