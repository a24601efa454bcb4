#pragma once
// Matrices of one body, summed up from its elements' matrices.

#include <petscmat.h>

#include <Eigen/Core>
#include <functional>
#include <span>
#include <vector>

#include "idiophone/foundation/parallel/petsc.hpp"
#include "idiophone/solids/mesh/part.hpp"

namespace idiophone::motion {

/// Which row and column of a matrix each component is.
struct Components {
  std::vector<PetscInt> number;  ///< [3 x local nodes] of 3 node + axis: its number over all ranks; -1 where left out
  PetscInt begin = 0;            ///< the owned ones have the numbers [begin, end)
  PetscInt end = 0;
};

/// An empty sparse matrix with room wherever two components share an element. Each rank fills the rows it owns, and
/// what it adds to others is dropped: their owners add the same. Collective.
/// @throws std::runtime_error where PETSc can't
[[nodiscard]] parallel::Handle<Mat> create_matrix(const mesh::BodyPart& body, const Components& components,
                                                  MPI_Comm communicator);

/// The matrix of an element at a place in BodyPart::element_ids: [3 nodes x 3 nodes], row and column 3 a + i for node a
/// and direction i; symmetric.
using ElementMatrix = std::function<Eigen::MatrixXd(std::size_t place)>;

/// Adds the matrices of all elements computed here, in ascending order, so that the sums do not depend on the parts.
/// The caller assembles the matrix.
/// @throws std::runtime_error where PETSc can't
void add_elements(const mesh::BodyPart& body, const Components& components, const ElementMatrix& element_matrix,
                  Mat matrix);

}  // namespace idiophone::motion
