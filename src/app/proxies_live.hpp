#pragma once
// Proxies in real time.

#include <optional>
#include <string>
#include <vector>

#include "idiophone/instruments/proxies/engine.hpp"
#include "idiophone/instruments/score/score.hpp"
#include "idiophone/scene/scene.hpp"

namespace idiophone::app {

struct LiveProxies {
  std::optional<int> osc;   ///< UDP port
  std::string device;       ///< part of its name; empty for the default one
  int frames = 256;         ///< of an audio buffer
  int buffers = 8;          ///< that are computed ahead
  double full_scale = 1.0;  ///< of the audio device, Pa
};

/// Plays until the score is over, or a signal comes if OSC is heard.
/// @param names  of the bodies, for OSC
/// @throws std::runtime_error when there is no audio device, or it stops
void play_proxies(proxies::Engine& engine, const score::Score& score, const std::vector<std::string>& names, int rate,
                  const LiveProxies& options);

}  // namespace idiophone::app
