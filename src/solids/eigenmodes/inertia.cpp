#include "inertia.hpp"

#include <fmt/format.h>
#include <petscksp.h>

#include <stdexcept>

#include "shifted_matrix.hpp"

namespace idiophone::eigenmodes {

using parallel::petsc;

PetscInt eigenvalues_below(const EigenProblem& problem, double bound) {
  const parallel::Handle<Mat> shifted = shifted_matrix(problem, -bound);
  parallel::Handle<Mat> factors;
  petsc(MatGetFactor(shifted, MATSOLVERMUMPS, MAT_FACTOR_CHOLESKY, factors.out()));
  petsc(MatSetOptionsPrefix(factors, "modes_st_"));  // as the factors of the search
  petsc(MatMumpsSetIcntl(factors, 13, 1));           // all pivots are counted, also those of the last front
  petsc(MatMumpsSetIcntl(factors, 14, 100));         // per cent of room for pivots that must wait
  MatFactorInfo settings;
  petsc(MatFactorInfoInitialize(&settings));
  petsc(MatCholeskyFactorSymbolic(factors, shifted, nullptr, &settings));
  petsc(MatCholeskyFactorNumeric(factors, shifted, &settings));
  MatFactorError error = MAT_FACTOR_NOERROR;
  petsc(MatFactorGetError(factors, &error));
  if (error != MAT_FACTOR_NOERROR) {
    PetscInt info = 0;
    petsc(MatMumpsGetInfog(factors, 1, &info));
    throw std::runtime_error(fmt::format(
        "the modes can't be counted, as MUMPS can't factorise the matrix (INFOG(1) = {}): use a coarser mesh "
        "or more memory",
        info));
  }
  PetscInt negative = 0;
  petsc(MatGetInertia(factors, &negative, nullptr, nullptr));
  return negative;
}

}  // namespace idiophone::eigenmodes
