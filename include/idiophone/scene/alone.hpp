#pragma once
// One body of a deck, for itself.

#include "idiophone/scene/scene.hpp"

namespace idiophone::scene {

/// The scene with nothing that moves in it but one body and what holds it: no loads, contacts or other bodies.
/// @param body  index into Scene::bodies
[[nodiscard]] Scene alone(Scene scene, std::size_t body);

}  // namespace idiophone::scene
