#include "idiophone/run/bodies/air_coupling.hpp"

#include "steps.hpp"

namespace idiophone::bodies {

namespace {

/// Driven bodies move the air, even where nothing of them is free.
std::vector<bool> moving_bodies(const Preparation& ready) {
  std::vector<bool> moving;
  for (std::size_t b = 0; b < ready.scene.bodies.size(); ++b) {
    moving.push_back(!is_held_everywhere(ready, b) || !ready.scene.bodies[b].driven.empty());
  }
  return moving;
}

}  // namespace

AirCoupling::AirCoupling(const Preparation& ready, motion::Motion& motion, propagation::AirLoad& air,
                         MPI_Comm communicator)
    : motion_(motion),
      air_(air),
      interval_(ready.steps_per_sample / air.steps()),
      load_(motion::loaded_triangles(ready.part, moving_bodies(ready), communicator), ready.part.reference,
            interval_ * ready.step()),
      rows_(load_.triangles().places, load_.triangles().all, communicator),
      changes_(3 * load_.triangles().numbers.size()) {
  air.connect(load_.triangles().numbers);
  motion.add_load(load_);
}

void AirCoupling::after_step() {
  if (motion_.step_number() % interval_ != 0) {
    load_.go_on();
    return;
  }
  load_.end_interval(motion_.state(), changes_);
  air_.advance(changes_, load_.force(), load_.resistance());
  load_.begin_interval(motion_.state());
}

void AirCoupling::archive(parallel::Archive& archive) {
  load_.archive(archive, rows_, motion_.state());
}

}  // namespace idiophone::bodies
