#pragma once
// The faces of parts that gmsh meshes, as `idiophone check --faces` lists them.

#include <nlohmann/json.hpp>
#include <span>
#include <vector>

#include "idiophone/scene/body.hpp"
#include "idiophone/solids/mesh/mesh.hpp"

namespace idiophone::app {

/// For each body an object of its faces, in the order of their numbers, by the names that decks use: "area" (m2),
/// "normal" (the mean, which points outwards; shorter than 1 where the face is curved, zero where it is closed), "low"
/// and "high" (corners of its box on the placed body, m). Empty for the bodies of .geo and .msh files, which name their
/// groups themselves.
/// @param meshes  of the bodies
[[nodiscard]] nlohmann::ordered_json faces_of(std::span<const scene::Body> bodies,
                                              const std::vector<mesh::Mesh>& meshes);

/// Prints a table for each body.
void print_faces(const nlohmann::ordered_json& faces);

}  // namespace idiophone::app
