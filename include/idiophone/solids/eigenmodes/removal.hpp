#pragma once
// How the frequencies of modes change where material is removed from the surface of a body.

#include <vector>

#include "idiophone/scene/solids.hpp"
#include "idiophone/solids/eigenmodes/eigenmodes.hpp"
#include "idiophone/solids/mesh/mesh.hpp"
#include "idiophone/solids/motion/attachments.hpp"

namespace idiophone::eigenmodes {

/// What removed material does to modes, at the nodes of the surface.
struct RemovalSlopes {
  std::vector<Index> nodes;    ///< of the surface, ascending; without faces that are held
  std::vector<Vector3> areas;  ///< [nodes] area of the surface that belongs to each, times its outward normal, m2
  std::vector<std::vector<double>> slopes;  ///< [modes][nodes] cents for each m3 that is removed there
};

/// Hadamard's derivative of a frequency by the shape. Where the surface recedes by a small depth h, w^2 of a mode x of
/// unit modal mass changes by minus the integral of h (stress : strain - w^2 density |x|^2) over the surface: strained
/// material makes the body stiff, and moving material makes it heavy. Thus a mode changes by the sum of
/// -slopes_i areas_i . d_i cents if the surface moves by small ways d_i at the nodes. Strains at nodes are means over
/// the elements of one material. Modes of one frequency have the derivatives of their shapes; only their mean has a
/// meaning.
/// @param solids       of one body
/// @param mesh         of the body
/// @param attachments  of the body
/// @param modes        of the body, with shapes of all nodes
/// @throws deck::DeckError where the body has a prestress, whose change the formula leaves out, and as
///         solid::fit_relaxation()
[[nodiscard]] RemovalSlopes removal_slopes(const scene::Solids& solids, const mesh::Mesh& mesh,
                                           const motion::Attachments& attachments, const std::vector<Mode>& modes);

}  // namespace idiophone::eigenmodes
