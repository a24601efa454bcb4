#pragma once
// An orthonormal basis in which given vectors have as few large numbers as possible.

#include <Eigen/Core>

namespace idiophone::eigenmodes {

/// Turns orthonormal directions in the space that they span so that the fourth powers of what is seen along them have
/// the largest sum: quartimax (J. O. Neuhaus and C. Wrigley, Brit. J. Stat. Psych. 7, 1954), by planar rotations. The
/// same energy then lies in fewer numbers.
/// @param directions  [strains x terms]
/// @param seen        [numbers x terms] along each
/// @return            the new directions
[[nodiscard]] Eigen::MatrixXd quartimax(Eigen::MatrixXd directions, Eigen::MatrixXd seen);

}  // namespace idiophone::eigenmodes
