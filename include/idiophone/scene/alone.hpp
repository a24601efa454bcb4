#pragma once
// One body of a deck.

#include <string>

#include "idiophone/scene/scene.hpp"

namespace idiophone::scene {

/// Index of a body of the deck. @param name  empty for the first
/// @throws std::runtime_error, with the names of the deck's bodies, if there is none of this name
[[nodiscard]] std::size_t find_body(const Scene& scene, const std::string& name);

/// The scene with nothing that moves in it but one body and what holds it: no loads, contacts or other bodies.
/// @param body  index into Scene::bodies
[[nodiscard]] Scene alone(Scene scene, std::size_t body);

}  // namespace idiophone::scene
