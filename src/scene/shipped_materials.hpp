#pragma once
// Materials that the program brings along, to be used by name. docs/use/materials.md shows them with their sources.

#include <vector>

#include "idiophone/scene/scene.hpp"

namespace idiophone::scene {

/// All of them, in the order of docs/use/materials.md. The axes x, y, z of woods are along the grain, across the rings
/// (radial) and along the rings (tangential). Their damping holds the loss factor; decks get it if they ask for
/// it.
[[nodiscard]] const std::vector<Material>& shipped_materials();

}  // namespace idiophone::scene
