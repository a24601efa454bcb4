#pragma once
// What the materials of a body have in common.

#include <span>

#include "idiophone/scene/body.hpp"
#include "idiophone/scene/material.hpp"

namespace idiophone::scene {

/// The smallest Young's modulus of a body's materials, Pa.
/// @param materials  of the scene
[[nodiscard]] double softest_modulus(const Body& body, std::span<const Material> materials);

/// Whether no material of a body has damping: then only the air and what touches it take energy from its vibration.
/// @param materials  of the scene
[[nodiscard]] bool is_undamped(const Body& body, std::span<const Material> materials);

/// What is said of such a body.
inline constexpr const char* undamped_in_words =
    "its material has no damping, so its vibration does not die away by itself (docs/use/materials.md#loss-factor)";

}  // namespace idiophone::scene
