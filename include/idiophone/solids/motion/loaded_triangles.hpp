#pragma once
// The triangles on which the air presses, and the faces of elements that they are parts of.

#include <mpi.h>

#include <Eigen/Core>
#include <array>
#include <memory>
#include <vector>

#include "idiophone/solids/mesh/part.hpp"

namespace idiophone::motion {

/// A triangle of the surface. Its normal velocity is the linear function that is nearest to that of the element's face.
struct LoadedTriangle {
  std::array<Index, 3> corners;                    ///< local nodes, in the order that makes the normal point outwards
  std::vector<Index> nodes;                        ///< local nodes of the face
  std::shared_ptr<const Eigen::Matrix3Xd> shapes;  ///< [3 corners x nodes] see element::linear_part()
};

/// Those that a rank needs.
struct LoadedTriangles {
  std::vector<Index> numbers;             ///< global, ascending
  std::vector<Index> places;              ///< [numbers] among those of all ranks, ascending likewise
  Index all = 0;                          ///< of all ranks, each counted once
  std::vector<LoadedTriangle> triangles;  ///< [numbers]
};

/// The triangles of all faces that have a node which this rank owns. Collective.
/// @param moving  [bodies] which are wanted; one that is fixed everywhere neither moves the air nor feels it
[[nodiscard]] LoadedTriangles loaded_triangles(const mesh::Part& part, const std::vector<bool>& moving,
                                               MPI_Comm communicator);

}  // namespace idiophone::motion
