#pragma once
// Points that are spread evenly over a unit cube (Halton 1960).

#include <Eigen/Core>

namespace idiophone::fitting {

/// A point of Halton's sequence, within the middle nine tenths of each direction.
/// @param number  from 1 on
/// @return [directions] 0.05 to 0.95
[[nodiscard]] Eigen::VectorXd halton_point(int number, Eigen::Index directions);

}  // namespace idiophone::fitting
