#include "idiophone/solids/motion/motion.hpp"

#include <algorithm>

#include "central_difference.hpp"
#include "idiophone/foundation/parallel/petsc.hpp"
#include "idiophone/solids/motion/ghost_exchange.hpp"
#include "idiophone/solids/solid/leapfrog.hpp"
#include "state_exchange.hpp"
#include "velocity_exchange.hpp"

namespace idiophone::motion {

using parallel::petsc;

namespace {

constexpr int state_width = sizeof(NodeState) / sizeof(double);
constexpr int force_width = sizeof(NodeForce) / sizeof(double);

/// A step's number in PETSc's 32 bits: it starts again at 0 every 2^30 steps.
PetscInt petsc_number(std::int64_t step_number) {
  return static_cast<PetscInt>(step_number % (std::int64_t{1} << 30));
}

}  // namespace

PetscErrorCode Motion::compute_force(TS /*ts*/, PetscReal time, Vec state, Vec force, void* context) {
  PetscFunctionBegin;
  auto* motion = static_cast<Motion*>(context);
  const PetscScalar* u = nullptr;
  PetscScalar* f = nullptr;
  PetscCall(VecGetArrayRead(state, &u));
  PetscCall(VecGetArrayWrite(force, &f));
  const std::span states(reinterpret_cast<const NodeState*>(u), motion->state_.size());
  const std::span forces(reinterpret_cast<NodeForce*>(f), motion->force_.size());
  motion->dynamics_.begin_force(states, forces);
  motion->receive_ghosts();
  motion->dynamics_.finish_force(time, states, forces);
  motion->add_outer_forces(states, forces);
  PetscCall(VecRestoreArrayWrite(force, &f));
  PetscCall(VecRestoreArrayRead(state, &u));
  PetscFunctionReturn(0);
}

Motion::Motion(const scene::Solids& solids, const mesh::Part& part, const Attachments& attachments,
               const contact::ContactSurfaces& contact_surfaces, double step, int steps_per_update,
               MPI_Comm communicator, const ModelMaker& models, int most_at_once, accelerator::Accelerator* accelerator)
    : bodies_(solids.bodies),
      part_(part),
      dynamics_(solids, part, attachments, models, accelerator),
      contacts_(solids, part, contact_surfaces, step, steps_per_update, communicator),
      step_(step),
      steps_per_update_(steps_per_update),
      most_at_once_(most_at_once),
      state_(part.node_ids.size()),
      force_(part.node_ids.size()),
      ghost_exchange_(ghost_exchange(part, communicator)),
      velocity_exchange_(velocity_exchange(solids, part, ghost_exchange_, communicator)),
      node_rows_(std::span(part.node_ids).first(part.owned_nodes), part.global_nodes, communicator) {
  dynamics_.begin(step_);
  if (velocity_exchange_->is_slow()) {
    dynamics_.hide_exchange();
  }
  petsc(VecCreateMPIWithArray(communicator, state_width, part.owned_nodes * state_width, PETSC_DETERMINE,
                              state_.front().displacement, state_vector_.out()));
  petsc(VecCreateMPIWithArray(communicator, force_width, part.owned_nodes * force_width, PETSC_DETERMINE,
                              force_.front().component, force_vector_.out()));
  petsc(register_central_difference());
  petsc(TSCreate(communicator, ts_.out()));
  petsc(TSSetProblemType(ts_, TS_NONLINEAR));
  petsc(TSSetType(ts_, central_difference));
  petsc(TSSetApplicationContext(ts_, this));
  petsc(TSSetRHSFunction(ts_, force_vector_, compute_force, this));
  petsc(TSSetSolution(ts_, state_vector_));
  petsc(TSSetExactFinalTime(ts_, TS_EXACTFINALTIME_STEPOVER));
  petsc(TSSetMaxSteps(ts_, PETSC_MAX_INT - 1));
  petsc(TSSetFromOptions(ts_));
  petsc(TSSetTimeStep(ts_, step_));
  petsc(TSSetUp(ts_));
}

Motion::~Motion() = default;

void Motion::start(const std::vector<Vector3>& centres, std::span<const double> displacement) {
  if (!displacement.empty()) {
    for (Index node = 0; node < part_.owned_nodes; ++node) {
      std::copy_n(&displacement[3UL * part_.node_ids[node]], 3, state_[node].displacement);
    }
  }
  dynamics_.start(bodies_, centres, state_);
  update_nodes();
  begin_at(0, contact::BondUpdate::stretch);
}

void Motion::archive(parallel::Archive& archive, std::int64_t step_number) {
  if (!archive.restoring()) {
    update_nodes();
  }
  contacts_.archive(archive, node_rows_);
  archive.sum("motion/work", work_);
  archive.rows("motion/nodes", node_rows_, [this](std::size_t node, parallel::ArchiveRow& row) {
    row.values(state_[node].displacement);
    row.values(state_[node].velocity);
  });
  dynamics_.archive(archive);
  if (archive.restoring()) {
    begin_at(step_number, contact::BondUpdate::keep);
  }
}

void Motion::advance_to(std::int64_t step_number) {
  while (step_number_ < step_number) {
    petsc(TSSetStepNumber(ts_, petsc_number(step_number_)));
    petsc(TSStep(ts_));
  }
  receive_ghosts();
}

void Motion::add_sums(const InitialState& initial_state, std::span<BodySums> sums) {
  dynamics_.update_all(state_);
  dynamics_.compute_force(time(), state_, force_);
  add_outer_forces(state_, force_);
  dynamics_.add_sums({step_number_, step_}, force_, state_, initial_state, sums);
}

void Motion::add_outer_forces(std::span<const NodeState> state, std::span<NodeForce> force) const {
  contacts_.add_force(force);
  if (surface_load_ != nullptr) {
    surface_load_->add(state, force);
  }
}

void Motion::choose_nodes() {
  if (step_number_ % steps_per_update_ == 0) {
    const double end = static_cast<double>(step_number_ + steps_per_update_) * step_;
    std::vector<Index> nodes = contacts_.owned_near();
    if (surface_load_ != nullptr) {
      nodes.insert(nodes.end(), surface_load_->nodes().begin(), surface_load_->nodes().end());
    }
    dynamics_.choose_nodes(std::move(nodes), {time(), end}, most_at_once_);
  }
}

void Motion::begin_at(std::int64_t step_number, contact::BondUpdate bonds) {
  step_number_ = step_number;
  petsc(TSSetTime(ts_, static_cast<double>(step_number) * step_));
  StateExchange(part_, ghost_exchange_).receive(state_);
  contacts_.compute_forces(step_number, state_, bonds);
  choose_nodes();
}

void Motion::send_ghosts() {
  velocity_exchange_->send(state_);
  ghosts_travel_ = true;
}

void Motion::receive_ghosts() {
  if (ghosts_travel_) {
    velocity_exchange_->receive(state_);
    if (!velocity_exchange_->has_displacements()) {
      solid::update_displacements(step_, std::span(state_).subspan(part_.owned_nodes));
    }
    ghosts_travel_ = false;
  }
}

}  // namespace idiophone::motion
