#pragma once
// Names that a deck gives to faces of STEP, BREP, STL and OBJ parts.

#include <map>
#include <string>

#include "idiophone/scene/sections.hpp"

namespace idiophone::scene {

/// Descriptions of faces as the mesh understands them (add_described_groups() in solids/mesh/numbered_faces.hpp), by
/// their names in the deck.
using FaceGroups = std::map<std::string, std::string>;

/// The key groups of a body.
[[nodiscard]] FaceGroups read_face_groups(Section& body);

/// Puts the description in the place of a name.
void describe_group(const FaceGroups& groups, std::string& name);

}  // namespace idiophone::scene
