#include "idiophone/run/bodies/air_coupling.hpp"

namespace idiophone::bodies {

AirCoupling::AirCoupling(const Preparation& ready, motion::Motion& motion, propagation::AirLoad& air,
                         MPI_Comm communicator)
    : motion_(motion),
      air_(air),
      interval_(ready.steps_per_sample / air.steps()),
      load_(motion::loaded_triangles(ready.part, communicator), ready.part.reference, interval_ * ready.step()),
      rows_(load_.triangles(), ready.part.global_triangles, communicator),
      changes_(3 * load_.triangles().size()) {
  air.connect(load_.triangles());
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
