#pragma once
// Joints between refined meshes that act as those between the given ones.

#include <vector>

#include "idiophone/solids/joints/held_parts.hpp"
#include "idiophone/solids/joints/meshed_joint.hpp"

namespace idiophone::joints {

/// Makes joints between refined meshes as stiff as those between the given meshes, and springs, hinges and shanks
/// stretch under each motion of the given meshes as they do there. What is added to their weights is the smallest such
/// change by its sum of squares.
/// @param given   between the given meshes
/// @param joints  between the refined meshes, as many, which hold refined() parts
void act_as(std::vector<MeshedJoint> given, const scene::Solids& solids, const std::vector<mesh::Mesh>& meshes,
            const std::vector<mesh::RefinedMesh>& refined, std::vector<MeshedJoint>& joints);

}  // namespace idiophone::joints
