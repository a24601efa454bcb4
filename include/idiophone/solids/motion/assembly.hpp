#pragma once
// Matrices of bodies, summed up from their elements' matrices.

#include <petscmat.h>

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "idiophone/foundation/parallel/petsc.hpp"
#include "idiophone/solids/joints/joints.hpp"
#include "idiophone/solids/mesh/part.hpp"
#include "idiophone/solids/solid/solid.hpp"

namespace idiophone::motion {

/// Which row and column of a matrix each component is.
struct Components {
  std::vector<PetscInt> number;  ///< [3 x local nodes] of 3 node + axis: its number over all ranks; -1 where left out
  PetscInt begin = 0;            ///< the owned ones have the numbers [begin, end)
  PetscInt end = 0;
};

/// What a matrix couples: a consistent mass does not couple different axes.
enum class Coupling : std::uint8_t { of_all_axes, of_each_axis };

/// A sparse matrix of zeros wherever two components share an element or are coupled. Each rank fills the rows
/// it owns, and what it adds to others is dropped: their owners add the same. Collective.
/// @param bodies   whose components the rows are, as the part has them one after the other
/// @param coupled  sets of local nodes
/// @throws std::runtime_error where PETSc can't
[[nodiscard]] parallel::Handle<Mat> create_matrix(std::span<const mesh::BodyPart> bodies, const Components& components,
                                                  Coupling coupling, MPI_Comm communicator,
                                                  std::span<const std::vector<Index>> coupled = {});

/// The matrix of an element at a place in BodyPart::element_ids: [3 nodes x 3 nodes], row and column 3 a + i for node a
/// and direction i; symmetric.
using ElementMatrix = std::function<Eigen::MatrixXd(std::size_t place)>;

/// Adds the matrices of all elements computed here, in ascending order, so that the sums do not depend on the parts.
/// The caller assembles the matrix.
/// @throws std::runtime_error where PETSc can't
void add_elements(const mesh::BodyPart& body, const Components& components, const ElementMatrix& element_matrix,
                  Mat matrix);

/// Which elasticity of a region of a solid.
using Moduli = const solid::Elasticity& (solid::Solid::*)(std::size_t region) const;

/// Adds the tangent stiffness of a body's elements about displacements, its prestress included. The caller assembles
/// the matrix.
/// @param body   of the part
/// @param state  [local nodes]
/// @throws std::runtime_error where PETSc can't
void add_tangent_stiffness(const mesh::Part& part, const mesh::BodyPart& body, const solid::Solid& solid, Moduli moduli,
                           std::span<const solid::NodeState> state, const Components& components, Mat matrix);

/// Adds the stiffness of all joints about displacements. The caller assembles the matrix.
/// @param state  [local nodes]
/// @throws std::runtime_error where PETSc can't
void add_joint_stiffness(const joints::Joints& joints, std::span<const solid::NodeState> state,
                         const Components& components, Mat matrix);

}  // namespace idiophone::motion
