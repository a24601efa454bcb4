#pragma once
// From the axes of a mesh's file to those of the scene.

#include <vector>

#include "idiophone/scene/body.hpp"

namespace idiophone::mesh {

/// Whether the deck turns or moves the body's mesh. If not, nodes keep the bits of the file.
[[nodiscard]] bool is_moved(const scene::Body& body);

/// Turns the nodes about the origin of their file and moves them, as the deck says.
/// @param nodes  m
/// @throws deck::DeckError, pointing at the body's mesh key, when one comes to lie too far from the origin
void put_in_place(const scene::Body& body, std::vector<Vector3>& nodes);

}  // namespace idiophone::mesh
