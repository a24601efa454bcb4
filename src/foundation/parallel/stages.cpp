#include "idiophone/foundation/parallel/stages.hpp"

#include <numeric>

#include "idiophone/foundation/parallel/clock.hpp"

namespace idiophone::parallel {

Stages::Stages() {
  for (std::size_t stage = 0; stage < stage_count; ++stage) {
    PetscLogStageRegister(stage_names[stage], &log_stages_[stage]);
  }
}

double Stages::total() const {
  return std::accumulate(seconds_.begin(), seconds_.end(), 0.0);
}

Stages::Scope::Scope(Stages& stages, Stage stage)
    : seconds_(stages.seconds_[static_cast<std::size_t>(stage)]), start_(wall_time()) {
  PetscLogStagePush(stages.log_stages_[static_cast<std::size_t>(stage)]);
}

Stages::Scope::~Scope() {
  seconds_ += wall_time() - start_;
  PetscLogStagePop();
}

}  // namespace idiophone::parallel
