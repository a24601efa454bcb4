#pragma once
// PETSc's error codes as exceptions.

#include <fmt/format.h>
#include <petscsys.h>

#include <stdexcept>

namespace idiophone::parallel {

/// @throws std::runtime_error with PETSc's message where a call failed
inline void petsc(PetscErrorCode code) {
  if (code != 0) {
    const char* text = nullptr;
    char* specific = nullptr;
    PetscErrorMessage(code, &text, &specific);
    throw std::runtime_error(fmt::format("PETSc: {} ({})", text != nullptr ? text : "unknown error",
                                         specific != nullptr ? specific : "no details"));
  }
}

}  // namespace idiophone::parallel
