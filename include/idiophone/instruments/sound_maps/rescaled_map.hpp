#pragma once
// Sound maps for another density, stiffness, damping or size, without solving for the modes again.

#include <filesystem>
#include <string>

#include "idiophone/instruments/sound_maps/sound_map.hpp"
#include "idiophone/scene/scene.hpp"

namespace idiophone::sound_maps {

/// The map of a body as the scene has it, from a map of the same body with another material, size or place: with the
/// factors e of all elastic constants, d of the density and s of all lengths, frequencies change by sqrt(e/d)/s and
/// shapes by 1/sqrt(d s^3) (docs/method/sound_map.md#rescaling). The body is meshed to prove that it is the same one.
/// Call on one rank. Fills in everything except for `code_version`. Where e = d and the air is that of the other map,
/// as are the listeners beside the body, the radiation is that of the other map by powers of d and s. Otherwise
/// listeners, sphere and `radiation_decay` are empty.
/// @param source         the other map
/// @param path           its file, for messages
/// @param body           index into Scene::bodies
/// @param resolved_deck  of the scene
/// @throws deck::DeckError or std::runtime_error where the modes are not those of the other map times factors: they
///         depend on more than one material, on a mesh, constraints or a ratio of elastic constants that differ, or the
///         map does not say what they depend on. deck::DeckError as mesh::read_mesh()
[[nodiscard]] SoundMap rescaled_map(const SoundMap& source, const std::filesystem::path& path,
                                    const scene::Scene& scene, std::size_t body, const std::string& resolved_deck);

}  // namespace idiophone::sound_maps
