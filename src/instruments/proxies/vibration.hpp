#pragma once
// The motion of a lattice: what a step of time makes of its displacements and velocities (O'Morain 2005, section 6.3).

#include <optional>
#include <span>

#include "idiophone/instruments/proxies/proxy.hpp"
#include "rigid_motion.hpp"
#include "spring_packs.hpp"
#include "spring_rows.hpp"

namespace idiophone::proxies {

class Vibration {
 public:
  /// At rest. @param lattice  must outlive it
  explicit Vibration(const Lattice& lattice);

  [[nodiscard]] const SpringPacks& springs() const { return springs_; }
  [[nodiscard]] std::size_t packs() const;  ///< of springs and dampers that are computed in each step
  [[nodiscard]] const Rows& displacement() const { return displacement_; }  ///< [masses, padded] m
  [[nodiscard]] const Rows& velocity() const { return velocity_; }          ///< likewise, m/s
  [[nodiscard]] double tension() const { return tension_; }                 ///< factor of all springs
  [[nodiscard]] const Damping& damping() const { return damping_; }

  void tune(double tension, const Damping& damping);
  void set_state(std::span<const Vector3> displacement, std::span<const Vector3> velocity);
  void stop();

  /// Forces on the three masses of each contact, in all steps until the next call. On a free body, less those that
  /// would move it as a rigid body.
  void load(std::span<const PointForce> forces);

  /// One step. @param step  s
  void step(Integrator integrator, double step);

  /// Takes away the rigid motion that rounding has given to a free body.
  void remove_rigid_motion();

  /// Whether a mass is farther from its place than a limit (m), or goes that far in an interval (s).
  [[nodiscard]] bool moves(double limit, double interval);

 private:
  /// Displacement by which springs alone would pull as springs and dampers do, if these are in proportion to each
  /// other; otherwise as the springs do.
  [[nodiscard]] FourRows effective_displacement(const FourRows& u, const FourRows& v) const;
  void find_effective_displacement();
  void find_forces(const Rows& velocity);
  void step_symplectic(float step);
  void step_improved(float step);

  const Lattice* lattice_;
  SpringPacks springs_;
  std::optional<SpringPacks> dampers_;  // that are not in proportion to the springs, over the largest proportion
  RigidMotion rigid_motion_;
  Damping damping_;
  double tension_ = 1.0;
  Rows inverse_mass_;  // [masses] three times the same; zero for pinned masses, 1/kg
  Rows displacement_, velocity_, load_, force_, effective_;  // [masses]; force_ is zero between steps
  Rows first_velocity_, first_acceleration_;                 // of an improved step
  Rows damped_;                                              // [masses] by which the dampers pull, m
  bool is_loaded_ = false;
  std::size_t moving_ = 0;  // a mass that moved when that was last asked: most often it still does
};

}  // namespace idiophone::proxies
