#pragma once
// The contact forces of a result, for proxies.

#include <filesystem>
#include <memory>
#include <vector>

#include "idiophone/instruments/proxies/engine.hpp"
#include "idiophone/scene/solids.hpp"

namespace idiophone::drivers {

/// Forces on the bodies of a scene from the contact channels of its result, in the coordinates of the undeformed
/// bodies.
/// @param centres  [bodies] centres of mass of the undeformed bodies, m
/// @throws std::runtime_error when the result can't be read, is damaged, or lacks the channels
[[nodiscard]] std::vector<proxies::Force> contact_forces(const std::filesystem::path& result,
                                                         const scene::Solids& solids,
                                                         const std::vector<Vector3>& centres);

}  // namespace idiophone::drivers
