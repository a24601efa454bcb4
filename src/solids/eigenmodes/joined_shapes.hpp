#pragma once
// What the modes of a body lack of its motion among joined bodies, as further vibrations of the body by itself.

#include <petscmat.h>

#include <Eigen/Core>
#include <vector>

#include "eigensolver.hpp"
#include "idiophone/solids/eigenmodes/eigenmodes.hpp"
#include "idiophone/solids/eigenmodes/joined_motion.hpp"
#include "operators.hpp"

namespace idiophone::eigenmodes {

/// The product of a matrix of the free components with fields at the owned nodes, one in each column.
[[nodiscard]] Eigen::MatrixXd product(Mat matrix, const Operators& operators, const Eigen::MatrixXd& fields);

/// Rayleigh and Ritz: stationary values of x^T K x/x^T M x among what rigid motions and modes lack of the joined
/// motion. They are orthogonal to those and to each other by M and by K. What takes a small share of the energy is left
/// out.
/// @param operators  of the body by itself, on one rank
/// @param found      its modes
/// @param rigid      its rigid motions
/// @return ascending
[[nodiscard]] std::vector<Eigenpair> joined_shapes(const Operators& operators, const Modes& found,
                                                   const std::vector<std::vector<double>>& rigid,
                                                   const JoinedMotion& motion);

}  // namespace idiophone::eigenmodes
