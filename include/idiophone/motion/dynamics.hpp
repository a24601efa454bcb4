#pragma once
// Newton's second law for this rank's nodes: forces from the state, and one step of central differences.

#include <cstdint>
#include <vector>

#include "idiophone/motion/constraints.hpp"
#include "idiophone/motion/loads.hpp"
#include "idiophone/solid/mass.hpp"
#include "idiophone/solid/solid.hpp"

namespace idiophone::motion {

class Dynamics {
 public:
  /// @throws std::runtime_error where an element is inverted (see solid::Solid)
  Dynamics(const scene::Scene& scene, const mesh::Part& part, const Attachments& attachments);

  /// From now on, materials with a loss factor remember their strain in steps of `step` (s); see solid::Solid.
  void begin_memory(double step);

  /// Forces on the owned nodes, N, from elasticity, stiffness-proportional damping, pulses and supports; gravity and
  /// mass-proportional damping come in `advance`. Needs the state of the ghosts, too.
  /// @param time   t_n, s
  /// @param state  [local nodes] u_n and v_{n-1/2}
  /// @param force  [local nodes] overwritten; meaningless at ghosts
  void compute_force(double time, const NodeState* state, NodeForce* force) const;

  /// The same, once a step: the materials' memory goes on to the present.
  void compute_force_and_remember(double time, const NodeState* state, NodeForce* force);

  /// Velocity over half a step (the first) or a whole one, then position over a step, of the owned nodes:
  /// v_{n+1/2} = v_{n-1/2} + dt a_n, u_{n+1} = u_n + dt v_{n+1/2}. Mass-proportional damping is centred in time.
  /// @param number  n; the first step's velocities are those of time 0
  /// @param step    dt, s
  /// @param force   [local nodes] N; changed where bodies have added mass
  /// @param work    what pulses and driven groups do in this step is added, J
  void advance(std::int64_t number, double step, NodeForce* force, NodeState* state, ReproducibleSum& work) const;

  /// Velocities at t_n from those at t_{n-1/2} and the forces at t_n, m/s. [owned nodes]
  /// @param force   [local nodes] N; changed where bodies have added mass
  void whole_step_velocities(double step, bool first, NodeForce* force, const NodeState* state,
                             std::vector<Vector3>& velocity) const;

  /// Initial state: at rest but for the bodies' velocity and spin, constraints in place. [local nodes]; owned ones are
  /// set
  /// @param centres  [bodies] centres of mass, m
  void start(const scene::Scene& scene, const std::vector<Vector3>& centres, NodeState* state) const;

  [[nodiscard]] const solid::Mass& mass(std::size_t body) const { return masses_[body]; }
  /// By how much mass scaling lowers the pitch of what can be heard of a body, at most, by an estimate; cents
  [[nodiscard]] double predicted_shift(std::size_t body) const { return predicted_shift_[body]; }
  [[nodiscard]] const std::vector<solid::Solid>& solids() const { return solids_; }
  [[nodiscard]] std::vector<solid::Solid>& solids() { return solids_; }
  [[nodiscard]] const Loads& loads() const { return loads_; }
  [[nodiscard]] const Constraints& constraints() const { return constraints_; }

 private:
  /// What a body's mass scaling makes; sets predicted_shift_.
  /// @param lumped  [local nodes] kg
  [[nodiscard]] solid::AddedMass added_mass(const scene::Scene& scene, const mesh::Part& part, std::size_t b,
                                            std::span<const double> lumped);

  const mesh::Part& part_;
  std::vector<solid::Solid> solids_;     ///< [bodies]
  std::vector<solid::Mass> masses_;      ///< [bodies]
  std::vector<double> predicted_shift_;  ///< [bodies] cents
  std::vector<double> mass_damping_;     ///< [bodies] alpha, 1/s
  Loads loads_;
  Constraints constraints_;
  Vector3 gravity_;
};

}  // namespace idiophone::motion
