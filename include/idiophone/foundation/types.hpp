#pragma once
// The few types that every module shares. Units are SI throughout: m, kg, s, N, Pa.

#include <Eigen/Core>
#include <cstdint>

namespace idiophone {

using Vector3 = Eigen::Vector3d;
using Index = std::int32_t;  ///< numbers nodes, elements, triangles; as wide as METIS's and PETSc's packaged indices

}  // namespace idiophone
