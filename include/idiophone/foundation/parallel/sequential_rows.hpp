#pragma once
// The rows of a PETSc matrix that is on one rank.

#include <petscmat.h>

#include <span>

#include "idiophone/foundation/parallel/petsc.hpp"

namespace idiophone::parallel {

/// Views of the rows of a sparse matrix (MATSEQAIJ) with all its entries in place. Values may be changed while this
/// object exists; other calls must wait.
class SequentialRows {
 public:
  /// Whether a matrix is of that type.
  [[nodiscard]] static bool are_of(Mat matrix) {
    PetscBool are = PETSC_FALSE;
    petsc(PetscObjectTypeCompare(reinterpret_cast<PetscObject>(matrix), MATSEQAIJ, &are));
    return are == PETSC_TRUE;
  }

  /// @throws std::runtime_error where PETSc can't
  explicit SequentialRows(Mat matrix) : matrix_(matrix) {
    PetscBool done = PETSC_FALSE;
    petsc(MatGetRowIJ(matrix, 0, PETSC_FALSE, PETSC_FALSE, &count_, &begins_, &columns_, &done));
    petsc(MatSeqAIJGetArray(matrix, &values_));
  }
  SequentialRows(const SequentialRows&) = delete;
  SequentialRows& operator=(const SequentialRows&) = delete;
  SequentialRows(SequentialRows&&) = delete;
  SequentialRows& operator=(SequentialRows&&) = delete;
  ~SequentialRows() {
    PetscBool done = PETSC_FALSE;
    MatSeqAIJRestoreArray(matrix_, &values_);
    MatRestoreRowIJ(matrix_, 0, PETSC_FALSE, PETSC_FALSE, &count_, &begins_, &columns_, &done);
  }

  [[nodiscard]] PetscInt count() const { return count_; }
  [[nodiscard]] std::span<const PetscInt> columns(PetscInt row) const { return {&columns_[begins_[row]], length(row)}; }
  [[nodiscard]] std::span<PetscScalar> values(PetscInt row) const { return {&values_[begins_[row]], length(row)}; }

 private:
  [[nodiscard]] std::size_t length(PetscInt row) const {
    return static_cast<std::size_t>(begins_[row + 1] - begins_[row]);
  }

  Mat matrix_;
  PetscInt count_ = 0;
  const PetscInt* begins_ = nullptr;
  const PetscInt* columns_ = nullptr;
  PetscScalar* values_ = nullptr;
};

}  // namespace idiophone::parallel
