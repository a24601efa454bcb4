#pragma once
// The bodies' motion in time on this rank, stepped by PETSc's TS, its ghosts kept up to date (paper, section 3.1).

#include <petscsf.h>
#include <petscts.h>

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "idiophone/foundation/parallel/archive.hpp"
#include "idiophone/foundation/parallel/petsc.hpp"
#include "idiophone/foundation/parallel/reproducible_sum.hpp"
#include "idiophone/solids/contact/contacts.hpp"
#include "idiophone/solids/motion/dynamics.hpp"
#include "idiophone/solids/motion/initial_state.hpp"
#include "idiophone/solids/motion/surface_load.hpp"

namespace idiophone::motion {

/// Name of the explicit central difference type that this module registers with TS.
inline constexpr const char* central_difference = "central_difference";

class VelocityExchange;

class Motion {
 public:
  /// PETSc must have been initialised.
  /// @param step              dt, s
  /// @param steps_per_update  steps between two updates of the contacts' broad phase
  /// @param models            see Dynamics
  /// @param most_at_once      steps that bodies may take at once where no contact and no pulse can act on them; a
  ///                          divisor of steps_per_update
  /// @param accelerator       see Dynamics
  /// @throws std::runtime_error where an element is inverted or PETSc refuses an option; see Dynamics
  Motion(const scene::Solids& solids, const mesh::Part& part, const Attachments& attachments,
         const contact::ContactSurfaces& contact_surfaces, double step, int steps_per_update, MPI_Comm communicator,
         const ModelMaker& models = finite_elements_only, int most_at_once = 1,
         accelerator::Accelerator* accelerator = nullptr);
  ~Motion();
  Motion(const Motion&) = delete;
  Motion& operator=(const Motion&) = delete;

  /// Balances the pulses that shall not move their bodies as a whole (scene::ForcePulse). Call it before the motion
  /// begins or is restored.
  void balance_loads(const InitialState& initial_state) { dynamics_.balance_loads(initial_state); }

  /// From now on, this load acts, too. It must outlive this object.
  void add_load(const SurfaceLoad& load) { surface_load_ = &load; }

  /// Begins at time 0.
  /// @param centres       [bodies] centres of mass, m
  /// @param displacement  [3 x global nodes] static preload, m; empty for none
  void start(const std::vector<Vector3>& centres, std::span<const double> displacement);

  /// All that decides the future, contacts included; restoring takes the place of start(). Collective.
  /// @param step_number  steps done: a restored motion goes on from there
  void archive(parallel::Archive& archive, std::int64_t step_number);

  /// One step of TS: one force evaluation, one halo exchange, no collective call. It is as long as several steps dt
  /// where all bodies here take several at once.
  void advance() { advance_to(step_number_ + 1); }

  /// Steps until this step number. Between them, ghosts travel while forces are computed.
  void advance_to(std::int64_t step_number);

  /// Brings the states of all owned nodes up to date: bodies that have a state of their own do so only for the broad
  /// phase of contacts.
  void update_nodes() { dynamics_.update_nodes(state_); }

  /// Brings the displacements of ghosts on an accelerator up to date, between two calls of advance_to().
  void update_ghosts_on_accelerator() { dynamics_.update_ghosts_on_accelerator(state_); }

  /// Adds what the bodies do now to their sums (see measure); changes nothing in the motion.
  /// @param sums  [bodies], then [pieces]
  void add_sums(const InitialState& initial_state, std::span<BodySums> sums);

  [[nodiscard]] std::int64_t step_number() const { return step_number_; }
  [[nodiscard]] double time() const { return static_cast<double>(step_number()) * step_; }  ///< s
  [[nodiscard]] const std::vector<NodeState>& state() const { return state_; }  ///< [local nodes]; see update_nodes
  [[nodiscard]] const ReproducibleSum& work() const { return work_; }  ///< of loads at this rank's nodes so far, J
  [[nodiscard]] const Dynamics& dynamics() const { return dynamics_; }
  [[nodiscard]] contact::Contacts& contacts() { return contacts_; }
  [[nodiscard]] const contact::Contacts& contacts() const { return contacts_; }

 private:
  friend PetscErrorCode step_central_difference(TS ts);

  void add_outer_forces(std::span<const NodeState> state, std::span<NodeForce> force) const;
  /// The velocities of nodes that are ghosts elsewhere.
  void send_ghosts();
  /// Moves the ghosts, if their velocities have been sent.
  void receive_ghosts();
  void choose_nodes();
  void begin_at(std::int64_t step_number, contact::BondUpdate bonds);
  static PetscErrorCode compute_force(TS ts, PetscReal time, Vec state, Vec force, void* context);

  std::span<const scene::Body> bodies_;
  const mesh::Part& part_;
  Dynamics dynamics_;
  contact::Contacts contacts_;
  const SurfaceLoad* surface_load_ = nullptr;
  double step_;
  int steps_per_update_;
  int most_at_once_;
  std::int64_t step_number_ = 0;  ///< PETSc counts in 32 bits and starts again now and then
  std::vector<NodeState> state_;  ///< the owned ones are TS's solution vector
  std::vector<NodeForce> force_;
  parallel::Handle<Vec> state_vector_;
  parallel::Handle<Vec> force_vector_;
  parallel::Handle<PetscSF> ghost_exchange_;             ///< of states at the start
  std::unique_ptr<VelocityExchange> velocity_exchange_;  ///< in each step
  bool ghosts_travel_ = false;                           ///< their velocities have been sent, and not yet received
  parallel::Rows node_rows_;                             ///< of the archive: owned nodes
  parallel::Handle<TS> ts_;
  ReproducibleSum work_;
};

}  // namespace idiophone::motion
