#pragma once
// What moves the nodes of one body that can be touched: finite elements, or rigid motion and modes.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "idiophone/foundation/parallel/archive.hpp"
#include "idiophone/foundation/parallel/reproducible_sum.hpp"
#include "idiophone/foundation/types.hpp"
#include "idiophone/scene/body.hpp"
#include "idiophone/solids/mesh/part.hpp"
#include "idiophone/solids/motion/body_sums.hpp"
#include "idiophone/solids/motion/step_limit.hpp"
#include "idiophone/solids/solid/node_state.hpp"

namespace idiophone::accelerated {
class AcceleratedSolid;
}

namespace idiophone::motion {

using solid::NodeForce;
using solid::NodeState;

/// The step from time t_n to t_{n+1}.
struct Step {
  Step(std::int64_t n, double dt)
      : number(n),
        length(dt),
        before(n == 0 ? 0.0 : dt),
        begin(static_cast<double>(n) * dt),
        end(static_cast<double>(n + 1) * dt) {}

  std::int64_t number;  ///< n
  double length;        ///< dt, s
  double before;        ///< length of the step before, s; zero in the first step
  double begin;         ///< t_n, s
  double end;           ///< t_{n+1}, s; kept, so that no fused multiplication rounds it elsewhere

  /// The first step's velocities are those of time 0, not of half a step before.
  [[nodiscard]] bool is_first() const { return before == 0.0; }
};

/// A body that moves by its modes, as a whole: its surface follows from this. Velocities are those of half a step
/// before, or of time 0.
struct ModalState {
  Vector3 shift;                   ///< of the centre of mass, m
  Eigen::Matrix3d turn_less_one;   ///< rotation of the body less the identity
  Vector3 velocity;                ///< of the centre of mass, m/s
  Vector3 spin;                    ///< angular velocity, rad/s
  std::span<const double> places;  ///< [modes] coordinates of the modes, kg^1/2 m
  std::span<const double> rates;   ///< [modes] their velocities, kg^1/2 m/s
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

  /// Sets the forces to zero at the owned nodes where `advance_velocities` reads them.
  virtual void clear_force(std::span<NodeForce> force) const = 0;

  /// Adds the forces of the body on its own nodes, N. Needs the state of the ghosts, too.
  virtual void add_internal_force(std::span<const NodeState> state, std::span<NodeForce> force) const = 0;

  /// The same, once a step and in two parts: what the body remembers of its strain goes on to the present. After
  /// hide_exchange(), the first part needs no ghosts.
  virtual void begin_internal_force(std::span<const NodeState> state, std::span<NodeForce> force) = 0;
  virtual void finish_internal_force(std::span<const NodeState> state, std::span<NodeForce> force) = 0;

  /// From now on, ghosts may still travel while the first part of the forces is computed.
  virtual void hide_exchange() = 0;

  /// The first half of a step: takes the velocities of the owned nodes from v_{n-1/2} to v_{n+1/2}. Where a body that
  /// lies on one rank has a state of its own, this state goes on instead.
  /// @param force  at t_n, N: all forces, gravity and mass-proportional damping excepted; may be changed
  /// @param work   what driven groups do in this step is added, J
  virtual void advance_velocities(const Step& step, std::span<NodeForce> force, std::span<NodeState> state,
                                  ReproducibleSum& work) = 0;

  /// The second half: takes the displacements of the owned nodes from u_n to u_{n+1}.
  virtual void advance_displacements(const Step& step, std::span<NodeState> state) = 0;

  /// From now on, forces act on these nodes alone, and a step has to bring only their states up to date.
  /// @param nodes           of any body, local numbers; ghosts do not count
  /// @param most_at_once    steps that may be taken at once: more than one where nothing but supports acts on the
  ///                        body. This step and all later calls are at multiples of it
  virtual void choose_nodes(std::span<const Index> nodes, int most_at_once) = 0;

  /// Steps that are taken at once: the body does nothing between them.
  [[nodiscard]] virtual int steps_at_once() const { return 1; }

  /// Brings the states of all owned nodes up to date.
  virtual void update_nodes(std::span<NodeState> state) = 0;

  /// Brings up to date what add_internal_force() and add_sums() need.
  virtual void update_all(std::span<NodeState> /*state*/) {}

  /// Of a body that moves by its modes, on the rank that has it.
  [[nodiscard]] virtual std::optional<ModalState> modal_state() const { return std::nullopt; }

  /// Of a body that an accelerator steps: its motion there.
  [[nodiscard]] virtual const accelerated::AcceleratedSolid* on_accelerator() const { return nullptr; }

  /// Brings the displacements of ghosts on an accelerator up to date.
  virtual void update_ghosts_on_accelerator(std::span<const NodeState> /*state*/) {}

  /// Lumped mass of the owned nodes, kg. [owned nodes of the body]
  [[nodiscard]] virtual std::span<const double> masses() const = 0;

  /// How much a force at an owned node accelerates it at once, at most, 1/kg: zero where it is held. [owned nodes of
  /// the body]
  [[nodiscard]] virtual std::vector<double> inverse_masses() const = 0;

  /// What limits the step of the body, its supports and constraints included, and contact left out: the same bits on
  /// any number of ranks. Collective.
  /// @param ranks  that the body lies on; it moves by its modes on one rank only
  /// @throws std::runtime_error if it is not found
  [[nodiscard]] virtual StableStep stable_step(const Supports& supports, const BodyRanks& ranks) const = 0;

  /// Memory of what grows with the body's share on this rank.
  [[nodiscard]] virtual std::size_t bytes() const = 0;

  /// Adds what the motion is at t_n to the sums; changes nothing in the motion.
  /// @param force   as for advance_velocities
  /// @param centre  of mass of the undeformed body, m
  /// @param sums    of the body, or of each of the pieces that it can fall apart into
  virtual void add_sums(const Step& step, std::span<NodeForce> force, std::span<const NodeState> state,
                        const Vector3& centre, const BodyUnits& unit, std::span<BodySums> sums) const = 0;

  /// All that decides the future, except the states of the nodes. Collective.
  virtual void archive(parallel::Archive& archive) = 0;
};

/// Makes the model of a body; null where the body consists of finite elements.
/// @param part  must outlive the model
/// @param body  its number in the part
using ModelMaker = std::function<std::unique_ptr<BodyModel>(const mesh::Part& part, std::size_t body)>;

/// All bodies consist of finite elements, whatever the scene says.
[[nodiscard]] inline std::unique_ptr<BodyModel> finite_elements_only(const mesh::Part& /*part*/, std::size_t /*body*/) {
  return nullptr;
}

}  // namespace idiophone::motion
