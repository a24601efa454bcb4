#pragma once
// How many modes there are below a frequency.

#include "eigen_problem.hpp"

namespace idiophone::eigenmodes {

/// Number of eigenvalues of K x = lambda M x below a bound, each as often as it occurs: the number of negative pivots
/// of K - bound M (Sylvester's law of inertia; Parlett, The Symmetric Eigenvalue Problem, 3.3). Collective.
/// @param bound  (rad/s)^2, further from every eigenvalue than rounding
/// @throws std::runtime_error where MUMPS fails, for instance without enough memory
[[nodiscard]] PetscInt eigenvalues_below(const EigenProblem& problem, double bound);

}  // namespace idiophone::eigenmodes
