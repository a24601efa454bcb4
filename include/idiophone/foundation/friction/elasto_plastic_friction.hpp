#pragma once
// Friction with memory between two surfaces that touch: bristles bend before they slide.

#include "idiophone/foundation/friction/law.hpp"

namespace idiophone::friction {

/// Length of z_v, the deflection of steady sliding at a speed (below), m.
/// @param speed  m/s
/// @param load   that presses the surfaces together, N
[[nodiscard]] double sliding_deflection(const Law& law, double speed, double load);

/// a, the share of sliding (below), for bristles that are not bent against the motion.
/// @param deflection  its length, m
[[nodiscard]] double share_of_sliding(const Law& law, double deflection, double speed, double load);

/// The y that solves y + way a(y) y/z_v = before + way: the deflection in the direction of the motion, after a way, m.
/// @param before  deflection before, negative if it is against the motion, m
/// @param way     on which the speed and the load stay the same, m
[[nodiscard]] double bent(const Law& law, double before, double way, double speed, double load);

/// The damping of the bristles, lower at high speed so that they never give energy (below), N s/m.
/// @param load  N, above 0
[[nodiscard]] double damping(const Law& law, double speed, double load);

/// The viscosity, lower where it would pull with more than `sticking` times the load: without load there is no force,
/// N s/m.
/// @param load  N, not negative
[[nodiscard]] double viscosity(const Law& law, double speed, double load);

/// Which deflection of the bristles makes the force of a time step.
enum class Deflection {
  mean,  ///< of those before and after the step
  end    ///< that after it
};

/// The elasto-plastic law (P. Dupont and others, IEEE Trans. Automatic Control 47, 2002; for sound F. Avanzini,
/// S. Serafin, D. Rocchesso, IEEE Trans. Speech and Audio Processing 13, 2005). Bristles of the deflection z follow the
/// relative velocity v,
///
///   z' = v (1 - a(z, v) z/z_v),   force = stiffness z + damping z' + viscosity v.
///
/// The last of these is at most `sticking` times the load.
/// z_v is the deflection of steady sliding: its force is load (sliding + (sticking - sliding) exp(-(v/v_s)^2)), with
/// the sign of v. a is the share of sliding: 0 up to the break-away deflection, 1 from z_v on, and linear between; 0 if
/// z is against v. Dupont's half sine in place of the line would not have a solution in closed form.
///
/// A time step uses one deflection z for a z and the force. With the mean of z before and after the step, the force
/// does exactly the work that is stored in the bristles, stiffness z^2/2, or lost, and the loss is never negative. For
/// this the damping falls at high speed, so that damping |v| stays below four times the force of sliding. With z at
/// the end of the step (implicit Euler), the force is that of its end: for motions whose velocities are known half a
/// step before their forces. Bristles that stick are then exact in either case.
class ElastoPlasticFriction {
 public:
  /// At rest. @param step  s
  ElastoPlasticFriction(const Law& law, double step, Deflection deflection = Deflection::mean);

  /// Force of the next step, against the motion of one surface over the other, N: its mean, or that of its end.
  /// @param velocity  mean of the relative velocity over the step, m/s
  /// @param load      that presses the surfaces together, N, not negative
  [[nodiscard]] double force(double velocity, double load) const;

  /// The mean velocity v for which v = free - mobility force(v), m/s. Of several ones it is one towards which the
  /// velocity goes from that of the step before, so that what sticks goes on to stick.
  /// @param free      velocity without friction, m/s
  /// @param mobility  m/s that a force of 1 N takes away; not negative
  [[nodiscard]] double velocity(double free, double mobility, double load) const;

  /// Takes the step.
  void advance(double velocity, double load);

  /// z, m.
  [[nodiscard]] double deflection() const { return deflection_; }
  /// In the bristles, J.
  [[nodiscard]] double stored_energy() const { return 0.5 * law_.stiffness * deflection_ * deflection_; }

  /// Names all state that decides the future.
  /// @param row  an archive's row (parallel::ArchiveRow)
  template <class Row>
  void archive(Row& row) {
    row.value(deflection_);
    row.value(velocity_);
  }

 private:
  /// The z that makes the force of a step.
  [[nodiscard]] double used_deflection(double velocity, double load) const;

  Law law_;
  double share_;  // of the step that is over where z is used
  double reach_;  // the same in s
  double deflection_ = 0.0;
  double velocity_ = 0.0;  // of the last step
};

}  // namespace idiophone::friction
