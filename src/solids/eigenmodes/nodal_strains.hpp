#pragma once
// Strains of modes at the nodes of a mesh.

#include <Eigen/Core>
#include <vector>

#include "idiophone/solids/eigenmodes/eigenmodes.hpp"
#include "idiophone/solids/mesh/mesh.hpp"

namespace idiophone::eigenmodes {

/// Strains of modes at nodes, in one region of a body: at each node the mean over the elements of the region.
/// @param wanted  [nodes] where strains are wanted; elsewhere they are zero
/// @return [modes] strains [6 x nodes] in the order of solid::direction_pairs, shear strains twice
[[nodiscard]] std::vector<Eigen::MatrixXd> nodal_strains(const mesh::Mesh& mesh, Index region,
                                                         const std::vector<bool>& wanted,
                                                         const std::vector<Mode>& modes);

/// The region that an element lies in; 0 in a body of one material.
[[nodiscard]] Index region_of(const mesh::Mesh& mesh, Index element);

}  // namespace idiophone::eigenmodes
