// The TS type "central_difference": one force evaluation a step, velocities at half steps, so that damping forces are
// seen (TSBASICSYMPLECTIC's force callback can't see velocities).

#include "central_difference.hpp"

#include <petsc/private/tsimpl.h>

#include "idiophone/motion/motion.hpp"

namespace idiophone::motion {

PetscErrorCode step_central_difference(TS ts) {
  PetscFunctionBegin;
  Motion* motion = nullptr;
  PetscCall(TSGetApplicationContext(ts, static_cast<void*>(&motion)));
  PetscCall(TSComputeRHSFunction(ts, ts->ptime, ts->vec_sol, motion->force_vector_));
  const std::int64_t number = motion->step_number_;
  motion->dynamics_.advance({number, ts->time_step}, motion->force_, motion->state_, motion->work_);
  if ((number + 1) % motion->steps_per_update_ == 0) {
    motion->update_nodes();
  }
  motion->update_ghosts();
  motion->contacts_.compute_forces(number + 1, motion->state_, contact::BondUpdate::stretch);
  motion->step_number_ = number + 1;
  motion->choose_nodes();
  ts->ptime = static_cast<double>(number + 1) * ts->time_step;
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
