#pragma once
// What is heard of a deck, and through what.

#include <span>

#include "idiophone/scene/body.hpp"
#include "idiophone/scene/listeners.hpp"
#include "idiophone/scene/radiation_section.hpp"
#include "idiophone/scene/settings.hpp"

namespace idiophone::scene {

struct Scene;

/// The listeners of a scene and the way of the sound to them. A view: the scene has to outlive it.
struct Acoustics {
  Acoustics(const Scene& scene);  // NOLINT(google-explicit-constructor): a scene is also its acoustics

  const Audio& audio;
  const Radiation& radiation;
  std::span<const Listener> listeners;
  std::span<const Body> bodies;              ///< that may carry listeners
  std::span<const ReferenceSet> references;  ///< frequencies that the sound is expected to have
};

}  // namespace idiophone::scene
