#pragma once
// Forces of a deck on its bodies.

#include <string>

#include "idiophone/scene/body.hpp"

namespace idiophone::scene {

/// A force on a patch of a body, multiplied by a signal.
struct ForcePulse {
  std::string name;
  std::size_t body = 0;  ///< index into Scene::bodies
  PatchPlace place;
  Vector3 force = Vector3::Zero();  ///< N, of the whole patch
  Signal signal;
  bool is_balanced = false;  ///< forces of inertia on the whole body cancel the resultant force and moment
};

/// The body starts in static equilibrium under this force, which is removed at time 0.
struct Pluck {
  std::string name;
  std::size_t body = 0;  ///< index into Scene::bodies
  PatchPlace place;
  Vector3 force = Vector3::Zero();  ///< N, of the whole patch
};

}  // namespace idiophone::scene
