#pragma once
// Bodies that joints tie together.

#include <span>
#include <string>
#include <vector>

#include "idiophone/scene/scene.hpp"
#include "idiophone/scene/solids.hpp"

namespace idiophone::scene {

/// Which bodies joints tie together, directly or not: indices into Scene::bodies, ascending, by the first of them. A
/// body without joints is by itself.
[[nodiscard]] std::vector<std::vector<std::size_t>> assemblies(const Scene& scene);

/// A body with all others that joints tie to it, directly or not, and these joints: no other bodies, and no loads,
/// contacts and gauges. The body comes first, and the others in the order of the deck.
[[nodiscard]] Scene assembly_of(Scene scene, std::size_t body);

/// Whether a joint holds the body.
[[nodiscard]] bool is_joined(std::size_t body, std::span<const Joint> joints);

/// @param work  what computes bodies one by one: "map"
/// @throws deck::DeckError, pointing at the first joint, if there is one
void refuse_joints(const Solids& solids, const std::string& work);

}  // namespace idiophone::scene
