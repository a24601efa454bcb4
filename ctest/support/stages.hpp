#pragma once
// The stages of a run, for tests: PETSc knows each name once.

#include "idiophone/parallel/stages.hpp"

namespace idiophone::test_support {

inline parallel::Stages& stages() {
  static parallel::Stages stages;
  return stages;
}

}  // namespace idiophone::test_support
