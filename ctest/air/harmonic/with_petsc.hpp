#pragma once

#include <gtest/gtest.h>
#include <petscsys.h>

#include <cstdlib>

namespace idiophone::harmonic {

/// Tests that need MPI or PETSc. A process can initialise them only once, and the long verification runs all tests in
/// one.
class WithPetsc : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    PetscBool is_ready = PETSC_FALSE;
    PetscInitialized(&is_ready);
    if (is_ready == PETSC_FALSE) {
      PetscInitializeNoArguments();
      std::atexit([] { PetscFinalize(); });
    }
  }
};

}  // namespace idiophone::harmonic
