#pragma once
// What the bodies that move by their modes need before the first step.

#include <vector>

#include "idiophone/run/bodies/preparation.hpp"

namespace idiophone::bodies {

/// The modes of all bodies that move by them. Runs on one rank.
/// @param meshes  of all bodies
/// @throws deck::DeckError, pointing at the model, where the mesh or the body does not have these modes
[[nodiscard]] modal_bodies::ModalBases find_modal_bases(const Preparation& ready,
                                                        const std::vector<mesh::Mesh>& meshes);

}  // namespace idiophone::bodies
