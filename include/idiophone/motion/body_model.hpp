#pragma once
// What moves the nodes of one body that can be touched: finite elements, or rigid motion and modes.

#include <cstdint>
#include <span>
#include <vector>

#include "idiophone/motion/body_sums.hpp"
#include "idiophone/parallel/archive.hpp"
#include "idiophone/parallel/reproducible_sum.hpp"
#include "idiophone/scene/scene.hpp"
#include "idiophone/solid/node.hpp"
#include "idiophone/types.hpp"

namespace idiophone::motion {

using solid::NodeForce;
using solid::NodeState;

/// The step from time t_n to t_{n+1}.
struct Step {
  Step(std::int64_t n, double dt)
      : number(n), length(dt), begin(static_cast<double>(n) * dt), end(static_cast<double>(n + 1) * dt) {}

  std::int64_t number;  ///< n
  double length;        ///< dt, s
  double begin;         ///< t_n, s
  double end;           ///< t_{n+1}, s; kept, so that no fused multiplication rounds it elsewhere

  /// The first step's velocities are those of time 0, not of half a step before.
  [[nodiscard]] bool is_first() const { return number == 0; }
};

/// Loads, supports and contacts read node states and write node forces, and do not know which model moves a body. A
/// step calls a model's functions once; states and forces are arrays over the rank's local nodes, of which a model
/// reads and writes its own body's. Between steps, velocities are those of t_{n-1/2}.
class BodyModel {
 public:
  BodyModel() = default;
  virtual ~BodyModel() = default;
  BodyModel(const BodyModel&) = delete;
  BodyModel& operator=(const BodyModel&) = delete;
  BodyModel(BodyModel&&) = delete;
  BodyModel& operator=(BodyModel&&) = delete;

  /// From now on, steps have this length, s.
  virtual void begin(double step) = 0;

  /// Sets the velocities of the owned nodes at time 0.
  /// @param body    its initial velocity and spin
  /// @param centre  of mass, m
  virtual void start(const scene::Body& body, const Vector3& centre, std::span<NodeState> state) = 0;

  /// Adds the forces of the body on its own nodes, N. Needs the state of the ghosts, too.
  virtual void add_internal_force(std::span<const NodeState> state, std::span<NodeForce> force) const = 0;

  /// The same, once a step: what the body remembers of its strain goes on to the present.
  virtual void add_internal_force_and_remember(std::span<const NodeState> state, std::span<NodeForce> force) = 0;

  /// Takes the owned nodes from u_n and v_{n-1/2} to u_{n+1} and v_{n+1/2}.
  /// @param force  at t_n, N: all forces, gravity and mass-proportional damping excepted; may be changed
  /// @param work   what driven groups do in this step is added, J
  virtual void advance(const Step& step, std::span<NodeForce> force, std::span<NodeState> state,
                       ReproducibleSum& work) = 0;

  /// From now on, `advance` has to bring only these nodes' states up to date, besides those that loads act on.
  /// @param nodes  owned nodes of any body, local numbers
  virtual void choose_nodes(std::span<const Index> nodes) = 0;

  /// Brings the states of all owned nodes up to date.
  virtual void update_nodes(std::span<NodeState> state) = 0;

  /// Brings the displacements of the owned nodes on the surface up to date; other nodes and velocities may stay behind.
  virtual void update_surface(std::span<NodeState> state) = 0;

  /// Lumped mass of the owned nodes, kg. [owned nodes of the body]
  [[nodiscard]] virtual std::span<const double> masses() const = 0;

  /// How much a force at an owned node accelerates it at once, at most, 1/kg: zero where it is held. [owned nodes of
  /// the body]
  [[nodiscard]] virtual std::vector<double> inverse_masses() const = 0;

  /// Adds what the motion is at t_n to the sums; changes nothing in the motion.
  /// @param force   as for advance
  /// @param centre  of mass of the undeformed body, m
  virtual void add_sums(const Step& step, std::span<NodeForce> force, std::span<const NodeState> state,
                        const Vector3& centre, const BodyUnits& unit, BodySums& sums) const = 0;

  /// The largest displacement so far over that up to which the model is right, where it has such a limit; on the ranks
  /// that have the body.
  [[nodiscard]] virtual double overload() const { return 0.0; }

  /// All that decides the future, except the states of the nodes. Collective.
  virtual void archive(parallel::Archive& archive) = 0;
};

}  // namespace idiophone::motion
