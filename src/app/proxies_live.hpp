#pragma once
// Proxies in real time.

#include "commands.hpp"
#include "idiophone/instruments/proxies/engine.hpp"
#include "idiophone/instruments/score/score.hpp"
#include "idiophone/scene/scene.hpp"

namespace idiophone::app {

/// Plays until the score is over, or a signal comes if OSC is heard.
/// @param names  of the bodies, for OSC
/// @throws std::runtime_error when there is no audio device, or it stops
void play_proxies(proxies::Engine& engine, const score::Score& score, const std::vector<std::string>& names, int rate,
                  const ProxiesOptions& options);

}  // namespace idiophone::app
