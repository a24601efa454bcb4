#pragma once
// What a mesh does to torsion.

#include "idiophone/solids/accuracy/pitch_error.hpp"

namespace idiophone::accuracy {

/// Cents by which torsion of a body about its longest axis may be wrong. Two causes:
/// - Edges. Along a free edge the warping of a twisted section decays within t/sqrt(12), t the thickness. Cells of low
///   order are too stiff there. Their energy is compared with that of Saint-Venant's torsion; the cells are even.
/// - Lumped mass of tetrahedra. It moves mass away from the centres of the elements, which raises the moment of inertia
///   of a section w x t of cells a x b by up to 0.5 (a^2 + b^2)/(w^2 + t^2) (docs/use/mesh_guide.md).
[[nodiscard]] double twist_error(const Cells& cells, const Extents& body);

}  // namespace idiophone::accuracy
