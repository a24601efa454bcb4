#include "idiophone/scene/acoustics.hpp"

#include "idiophone/scene/scene.hpp"

namespace idiophone::scene {

Acoustics::Acoustics(const Scene& scene)
    : audio(scene.audio),
      radiation(scene.radiation),
      listeners(scene.listeners),
      bodies(scene.bodies),
      references(scene.references) {}

}  // namespace idiophone::scene
