#pragma once
// Bodies that ring for ever, because a material has no damping unless the deck gives it one.

#include <vector>

#include "idiophone/scene/body.hpp"
#include "idiophone/scene/material.hpp"

namespace idiophone::scene {

/// Whether no material of a body has damping: then only the air and what touches it take energy from its vibration.
/// @param materials  of the scene
[[nodiscard]] bool is_undamped(const Body& body, const std::vector<Material>& materials);

/// What is said of such a body.
inline constexpr const char* undamped_in_words =
    "its material has no damping, so its vibration does not die away by itself (docs/use/materials.md#loss-factor)";

}  // namespace idiophone::scene
