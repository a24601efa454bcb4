#pragma once
// Receivers for sounds without time: those of single frequencies and of modes.

#include <span>
#include <string>
#include <vector>

#include "idiophone/foundation/types.hpp"
#include "idiophone/scene/listeners.hpp"

namespace idiophone::scene {

/// Where sound is received. A listener that moves stands where it is at time 0; a head hears the pressure at its
/// centre.
struct StillReceiver {
  std::string name;                    ///< of the channel: "ears.left"; of a head, that of the listener
  Vector3 position = Vector3::Zero();  ///< m
  const Receiver* receiver = nullptr;  ///< of the listener, with its directivity
};

/// In the order of the listeners and of their channels. The listeners have to outlive it.
[[nodiscard]] std::vector<StillReceiver> still_receivers(std::span<const Listener> listeners);

}  // namespace idiophone::scene
