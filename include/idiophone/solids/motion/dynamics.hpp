#pragma once
// Newton's second law for this rank's nodes: forces from the state, and one step of every body.

#include <memory>
#include <span>
#include <vector>

#include "idiophone/foundation/accelerator/accelerator.hpp"
#include "idiophone/solids/joints/joints.hpp"
#include "idiophone/solids/motion/body_fracture.hpp"
#include "idiophone/solids/motion/body_model.hpp"
#include "idiophone/solids/motion/constraints.hpp"
#include "idiophone/solids/motion/loads.hpp"
#include "idiophone/solids/solid/mass.hpp"
#include "idiophone/solids/solid/solid.hpp"

namespace idiophone::motion {

class FiniteElementBody;

/// Whether bodies get the mass scaling that the scene asks for.
enum class MassScaling { as_in_scene, none };

class Dynamics {
 public:
  /// @param part    must outlive this object
  /// @param models  of the bodies that do not consist of finite elements
  /// @param accelerator  which steps the finite elements; null: the processor does. It must outlive this object
  /// @throws std::runtime_error where an element is inverted (see solid::Solid), or a body is one that no accelerator
  ///         can step, or does not fit into its memory
  Dynamics(const scene::Solids& solids, const mesh::Part& part, const Attachments& attachments,
           const ModelMaker& models, accelerator::Accelerator* accelerator = nullptr);
  ~Dynamics();
  Dynamics(const Dynamics&) = delete;
  Dynamics& operator=(const Dynamics&) = delete;
  Dynamics(Dynamics&&) = delete;
  Dynamics& operator=(Dynamics&&) = delete;

  /// From now on, steps have this length, s: materials with a loss factor and bows begin to remember.
  void begin(double step);

  /// Initial state: at rest but for the bodies' velocity and spin, constraints in place. [local nodes]; owned ones are
  /// set
  /// @param centres  [bodies] centres of mass, m
  void start(std::span<const scene::Body> bodies, const std::vector<Vector3>& centres, std::span<NodeState> state);

  /// Forces on the owned nodes, N, from the bodies themselves, joints, pulses, winds, bows and supports; gravity and
  /// mass-proportional damping come in `advance_velocities`. Needs the state of the ghosts, too.
  /// @param time   t_n, s
  /// @param state  [local nodes] u_n and v_{n-1/2}
  /// @param force  [local nodes] overwritten; meaningless at ghosts
  void compute_force(double time, std::span<const NodeState> state, std::span<NodeForce> force) const;

  /// The same, once a step and in two parts: the materials' and bows' memory goes on to the present, and what winds do
  /// is noted for their work. After hide_exchange(), the first part needs no ghosts.
  void begin_force(std::span<const NodeState> state, std::span<NodeForce> force);
  void finish_force(double time, std::span<const NodeState> state, std::span<NodeForce> force);

  /// From now on, ghosts may still travel while the first part of the forces is computed.
  void hide_exchange();

  /// The first half of a step of the owned nodes; see BodyModel. Faces of fracture surfaces break here. After it, nodes
  /// that are ghosts elsewhere have their new velocities.
  /// @param force  [local nodes] N; changed where bodies have added mass
  /// @param work   what driven groups do in this step is added, J
  void advance_velocities(const Step& step, std::span<NodeForce> force, std::span<NodeState> state,
                          ReproducibleSum& work);

  /// The second half.
  /// @param work  what pulses, winds and bows do in this step is added, J
  void advance_displacements(const Step& step, std::span<NodeState> state, ReproducibleSum& work);

  /// Of the motion at t_n; see BodyModel::add_sums.
  /// @param force  changed where bodies have added mass or can break
  /// @param sums   [bodies], then [pieces]
  void add_sums(const Step& step, std::span<NodeForce> force, std::span<const NodeState> state,
                const InitialState& initial_state, std::span<BodySums> sums) const;

  /// From now on, balanced pulses have their forces of inertia; see Loads::balance.
  void balance_loads(const InitialState& initial_state);

  /// A time during which the chosen nodes stay the same.
  struct Period {
    double begin;  ///< s
    double end;    ///< s
  };

  /// From now on, a step brings only these nodes' states up to date, and those that loads act on, in bodies that
  /// have a state of their own.
  /// @param nodes         that contacts and the air may act on, local numbers; ghosts do not count
  /// @param most_at_once  steps that a body may take at once where only supports can act on it
  void choose_nodes(std::vector<Index> nodes, const Period& period, int most_at_once);

  /// Steps that the bodies here take at once, all of them: they do nothing between them.
  [[nodiscard]] int steps_at_once() const;

  /// Brings the states of all owned nodes up to date.
  void update_nodes(std::span<NodeState> state);

  /// See BodyModel.
  void update_all(std::span<NodeState> state);
  void update_ghosts_on_accelerator(std::span<const NodeState> state);

  /// All that decides the future, except the states of the nodes. Collective.
  void archive(parallel::Archive& archive);

  [[nodiscard]] const BodyModel& model(std::size_t body) const { return *bodies_[body]; }

  [[nodiscard]] const Loads& loads() const { return loads_; }
  [[nodiscard]] const Constraints& constraints() const { return constraints_; }
  [[nodiscard]] const joints::Joints& joints() const { return joints_; }
  /// Those whose forces act on bodies: not those that are part of common modes (scene::has_common_modes).
  [[nodiscard]] const joints::Joints& acting_joints() const { return acting_joints_; }
  [[nodiscard]] const std::vector<BodyFracture>& fractures() const { return fractures_; }  ///< of bodies that can break

 protected:
  /// Without bodies.
  Dynamics(const scene::Solids& solids, const mesh::Part& part, const Attachments& attachments);

  /// Adds the next body.
  /// @param lumped  [local nodes] the body's lumped mass is added, kg
  const FiniteElementBody& add_finite_elements(const scene::Solids& solids, MassScaling scaling,
                                               std::span<double> lumped);

 private:
  void clear(std::span<NodeForce> force) const;
  /// Loads and joints.
  void add_outer_forces(double time, std::span<const NodeState> state, std::span<NodeForce> force) const;

  const mesh::Part& part_;
  accelerator::Accelerator* accelerator_ = nullptr;
  Loads loads_;
  Constraints constraints_;
  joints::Joints joints_;
  joints::Joints acting_joints_;
  std::vector<std::unique_ptr<BodyModel>> bodies_;  ///< [bodies]
  std::vector<BodyFracture> fractures_;
};

/// The same with all bodies as finite elements, whatever the scene says, and broken along all fracture surfaces: their
/// mass and elasticity can be asked for.
class FiniteElementDynamics : public Dynamics {
 public:
  /// As for Dynamics.
  FiniteElementDynamics(const scene::Solids& solids, const mesh::Part& part, const Attachments& attachments,
                        MassScaling scaling = MassScaling::as_in_scene);

  [[nodiscard]] const solid::Mass& mass(std::size_t body) const;
  [[nodiscard]] const solid::Solid& solid(std::size_t body) const;
  /// By how much mass scaling lowers the pitch of what can be heard of a body, at most, by an estimate; cents
  [[nodiscard]] double predicted_shift(std::size_t body) const;

 private:
  std::vector<const FiniteElementBody*> finite_elements_;  ///< [bodies]
};

}  // namespace idiophone::motion
