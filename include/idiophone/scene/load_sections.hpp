#pragma once
// Forces of a deck on its bodies.

#include <cstdint>
#include <optional>
#include <string>

#include "idiophone/scene/body.hpp"
#include "idiophone/scene/bowing.hpp"

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

/// A bow rubs a patch of a body; see motion::BowLoad.
struct Bow : Bowing {
  std::string name;
  std::size_t body = 0;  ///< index into Scene::bodies
  PatchPlace place;
  double start = 0.0;  ///< s
};

/// Random changes of a wind, the same for each component.
struct Gusts {
  double intensity = 0.0;  ///< root mean square, in parts of the mean speed
  double time = 1.0;       ///< in which their correlation falls to 1/e, s
  std::uint64_t seed = 1;  ///< equal seeds are the same gusts
};

/// Moving air that pushes the surfaces which face it; see motion::Wind.
struct Wind {
  std::string name;
  std::optional<std::size_t> body;     ///< index into Scene::bodies; all of them if empty
  Vector3 velocity = Vector3::Zero();  ///< m/s, for a signal of 1
  double drag = 1.2;                   ///< its pressure over 1/2 density speed^2
  Gusts gusts;
  Signal signal;  ///< the air is at rest where it is 0
};

}  // namespace idiophone::scene
