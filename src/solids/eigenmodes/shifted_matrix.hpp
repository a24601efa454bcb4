#pragma once
// A stiffness that is shifted by the mass.

#include <petscmat.h>

#include "eigen_problem.hpp"

namespace idiophone::eigenmodes {

/// K + shift M, a new symmetric matrix. Collective.
/// @param shift  (rad/s)^2
/// @throws std::runtime_error where PETSc can't, for instance without enough memory
[[nodiscard]] parallel::Handle<Mat> shifted_matrix(const EigenProblem& problem, double shift);

}  // namespace idiophone::eigenmodes
