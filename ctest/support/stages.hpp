#pragma once
// The stages of a run, for tests: PETSc knows each name once.

#include "idiophone/foundation/parallel/stages.hpp"

namespace idiophone::support {

inline parallel::Stages& stages() {
  static parallel::Stages stages;
  return stages;
}

}  // namespace idiophone::support
