// The TS type "central_difference": one force evaluation a step, velocities at half steps, so that damping forces are
// seen (TSBASICSYMPLECTIC's force callback can't see velocities).

#include "central_difference.hpp"

#include <petsc/private/tsimpl.h>

#include "idiophone/solids/motion/motion.hpp"
#include "velocity_exchange.hpp"

namespace idiophone::motion {

PetscErrorCode step_central_difference(TS ts) {
  PetscFunctionBegin;
  Motion* motion = nullptr;
  PetscCall(TSGetApplicationContext(ts, static_cast<void*>(&motion)));
  PetscCall(TSComputeRHSFunction(ts, ts->ptime, ts->vec_sol, motion->force_vector_));
  const Step step(motion->step_number_, motion->step_);
  motion->dynamics_.advance_velocities(step, motion->force_, motion->state_, motion->work_);
  motion->send_ghosts();
  motion->dynamics_.advance_displacements(step, motion->state_, motion->work_);
  motion->step_number_ += motion->dynamics_.steps_at_once();
  const bool needs_all = motion->contacts_.needs_all_states(motion->step_number_);
  if (needs_all || !motion->velocity_exchange_->is_slow()) {
    motion->receive_ghosts();
  }
  if (needs_all) {
    motion->update_nodes();
  }
  motion->contacts_.compute_forces(motion->step_number_, motion->state_, contact::BondUpdate::stretch);
  motion->choose_nodes();
  ts->ptime = motion->time();
  PetscFunctionReturn(0);
}

namespace {

PetscErrorCode create_central_difference(TS ts) {
  PetscFunctionBegin;
  ts->ops->step = step_central_difference;
  ts->default_adapt_type = TSADAPTNONE;
  ts->usessnes = PETSC_FALSE;
  PetscFunctionReturn(0);
}

}  // namespace

PetscErrorCode register_central_difference() {
  PetscFunctionBegin;
  PetscCall(TSRegister(central_difference, create_central_difference));
  PetscFunctionReturn(0);
}

}  // namespace idiophone::motion
