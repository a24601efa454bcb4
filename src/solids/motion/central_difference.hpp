#pragma once

#include <petscts.h>

namespace idiophone::motion {

/// Makes the TS type "central_difference" known to PETSc; may be called again.
PetscErrorCode register_central_difference();

}  // namespace idiophone::motion
