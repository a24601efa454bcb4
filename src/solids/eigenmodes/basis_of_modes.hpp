#pragma once
// What modal bodies need of modes that were found.

#include <span>
#include <vector>

#include "idiophone/scene/solids.hpp"
#include "idiophone/solids/eigenmodes/eigenmodes.hpp"
#include "idiophone/solids/mesh/mesh.hpp"
#include "idiophone/solids/modal_bodies/modal_basis.hpp"
#include "operators.hpp"
#include "shifted_stiffness.hpp"

namespace idiophone::eigenmodes {

/// Frequencies, decay rates, shapes and masses.
/// @param bodies  how many there are; their nodes follow each other
[[nodiscard]] modal_bodies::ModalBasis basis_of(const Modes& found, const motion::Dynamics& dynamics,
                                                std::size_t bodies);

/// Unit normals of the surface at some of its nodes; of nodes inside, any direction.
[[nodiscard]] std::vector<Vector3> normals_at(std::span<const Index> nodes, const mesh::Mesh& mesh);

/// Twice the volume over the surface, m.
/// @param masses  of the body's nodes, kg
[[nodiscard]] double thickness_of(const scene::Solids& solids, const scene::Body& body, const mesh::Mesh& mesh,
                                  std::span<const double> masses);

/// With a shift where the body can move rigidly.
[[nodiscard]] ShiftedStiffness invertible_stiffness(const Operators& operators, const Modes& found);

}  // namespace idiophone::eigenmodes
