#pragma once
// A deck's parameters as the numbers that a .geo file defines with DefineConstant.

#include <filesystem>

#include "idiophone/scene/scene.hpp"

namespace idiophone::mesh {

/// Checks that the body's .geo file defines all of the body's parameters. Opens a gmsh session of its own.
/// @throws deck::DeckError, pointing at each parameter that it doesn't define.
void require_parameters(const scene::Body& body);

/// Opens the body's .geo file with the body's parameters in the present gmsh session.
/// @throws deck::DeckError, pointing at each parameter that the file overwrites; what gmsh throws.
void open_with_parameters(const scene::Body& body);

}  // namespace idiophone::mesh
