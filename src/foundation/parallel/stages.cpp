#include "idiophone/foundation/parallel/stages.hpp"

#include <numeric>
#include <utility>

#include "idiophone/foundation/parallel/clock.hpp"
#include "idiophone/foundation/parallel/petsc.hpp"

namespace idiophone::parallel {

Stages::Stages() {
  PetscBool logs = PETSC_FALSE;
  petsc(PetscOptionsHasName(nullptr, nullptr, "-log_view", &logs));
  is_logging_ = logs == PETSC_TRUE;
  for (std::size_t stage = 0; stage < stage_count && is_logging_; ++stage) {
    petsc(PetscLogStageRegister(stage_names[stage], &log_stages_[stage]));
  }
}

double Stages::total() const {
  return std::accumulate(seconds_.begin(), seconds_.end(), 0.0);
}

Stages::Scope::Scope(Stages& stages, Stage stage)
    : stages_(stages),
      seconds_(stages.seconds_[static_cast<std::size_t>(stage)]),
      outer_(std::exchange(stages.innermost_, this)),
      start_(wall_time()) {
  if (stages.is_logging_) {
    PetscLogStagePush(stages.log_stages_[static_cast<std::size_t>(stage)]);
  }
}

Stages::Scope::~Scope() {
  const double seconds = wall_time() - start_;
  seconds_ += seconds;
  if (outer_ != nullptr) {
    outer_->seconds_ -= seconds;
  }
  stages_.innermost_ = outer_;
  if (stages_.is_logging_) {
    PetscLogStagePop();
  }
}

}  // namespace idiophone::parallel
