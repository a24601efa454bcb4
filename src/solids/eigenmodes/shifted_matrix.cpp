#include "shifted_matrix.hpp"

#include <algorithm>

#include "idiophone/foundation/parallel/sequential_rows.hpp"

namespace idiophone::eigenmodes {

using parallel::petsc;

namespace {

/// Adds a multiple of M to K, which has all places that M has. PETSc would search for each place.
void add_mass(Mat stiffness, double factor, Mat mass) {
  if (!parallel::SequentialRows::are_of(stiffness)) {
    petsc(MatAXPY(stiffness, factor, mass, SUBSET_NONZERO_PATTERN));
    return;
  }
  const parallel::SequentialRows to(stiffness);
  const parallel::SequentialRows from(mass);
  for (PetscInt row = 0; row < from.count(); ++row) {
    auto place = to.columns(row).begin();
    for (std::size_t entry = 0; entry < from.columns(row).size(); ++entry) {
      place = std::ranges::find(place, to.columns(row).end(), from.columns(row)[entry]);
      to.values(row)[place - to.columns(row).begin()] += factor * from.values(row)[entry];
    }
  }
}

}  // namespace

parallel::Handle<Mat> shifted_matrix(const EigenProblem& problem, double shift) {
  parallel::Handle<Mat> matrix;
  petsc(MatDuplicate(problem.stiffness(), MAT_COPY_VALUES, matrix.out()));
  add_mass(matrix, shift, problem.mass());
  petsc(MatSetOption(matrix, MAT_SYMMETRIC, PETSC_TRUE));
  return matrix;
}

}  // namespace idiophone::eigenmodes
