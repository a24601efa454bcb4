#pragma once
// Bodies that joints tie together.

#include <span>
#include <string>

#include "idiophone/scene/joined_solids.hpp"
#include "idiophone/scene/scene.hpp"
#include "idiophone/scene/solids.hpp"

namespace idiophone::scene {

/// The scene of an Assembly: no other bodies, and no loads, contacts and gauges.
[[nodiscard]] Scene assembly_of(Scene scene, std::size_t body);

/// Whether a joint holds the body.
[[nodiscard]] bool is_joined(std::size_t body, std::span<const Joint> joints);

/// @param work  what computes bodies one by one: "map"
/// @throws deck::DeckError, pointing at the first joint, if there is one
void refuse_joints(const Solids& solids, const std::string& work);

}  // namespace idiophone::scene
