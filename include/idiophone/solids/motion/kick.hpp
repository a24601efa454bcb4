#pragma once

#include "idiophone/solids/motion/body_model.hpp"
#include "idiophone/solids/solid/leapfrog.hpp"

namespace idiophone::motion {

/// What a step of central differences does to velocities, with mass-proportional damping centred in time: they are
/// those of the middle of the step before. The first step starts from velocities at time 0: half a kick, all of its
/// damping from them.
/// @param damping  alpha, 1/s
[[nodiscard]] inline solid::Kick kick_of(const Step& step, double damping, const Vector3& gravity) {
  const double kick = (step.before + step.length) / 2;
  const double implicit = step.is_first() ? 0.0 : damping * step.length / 2;
  const double explicit_part = step.is_first() ? damping * kick : damping * step.before / 2;
  return {(1 - explicit_part) / (1 + implicit), kick / (1 + implicit), gravity};
}

}  // namespace idiophone::motion
