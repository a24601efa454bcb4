#pragma once
// Proxies in real time.

#include "commands.hpp"
#include "idiophone/proxies/engine.hpp"
#include "idiophone/scene/scene.hpp"
#include "idiophone/scene/score.hpp"

namespace idiophone::app {

/// Plays until the score is over, or a signal comes if OSC is heard.
/// @param names  of the bodies, for OSC
/// @throws std::runtime_error when there is no audio device, or it stops
void play_proxies(proxies::Engine& engine, const scene::Score& score, const std::vector<std::string>& names, int rate,
                  const ProxiesOptions& options);

}  // namespace idiophone::app
