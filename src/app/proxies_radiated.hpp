#pragma once
// Proxies that are heard through the radiation model of their deck.

#include <filesystem>
#include <vector>

#include "idiophone/instruments/proxy_bodies/proxy_source.hpp"
#include "idiophone/instruments/score/score.hpp"
#include "idiophone/scene/scene.hpp"

namespace idiophone::app {

/// Writes a result and its WAV files to a folder, as `run` does.
/// @param forces   on the bodies of the scene
/// @param options  the rate is chosen here
/// @return the exit status
/// @throws std::runtime_error for a score that tunes a body
int radiate_proxies(scene::Scene scene, const score::Score& score, const std::vector<proxy_bodies::ProxyBody>& bodies,
                    std::vector<proxies::Force> forces, const proxies::ProxyOptions& options,
                    const std::filesystem::path& folder);

}  // namespace idiophone::app
