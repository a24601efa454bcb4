#include "bristles.hpp"

#include <algorithm>

#include "idiophone/foundation/friction/elasto_plastic_friction.hpp"

namespace idiophone::contact {

Vector3 bend(const friction::Law& law, const Vector3& deflection, const Vector3& velocity, double load, double step) {
  const Vector3 free = deflection + step * velocity;
  const double length = free.norm();
  if (length == 0) {
    return free;
  }
  const double speed = velocity.norm();
  const double way = step * speed;
  const double bent = free.dot(velocity) > 0 ? friction::bent(law, length - way, way, speed, load) : length;
  const double longest = law.sticking * load / law.stiffness;
  return free * (std::min(bent, longest) / length);
}

Vector3 force_of_bristles(const friction::Law& law, const Vector3& deflection, const Vector3& velocity, double load) {
  const double speed = velocity.norm();
  Vector3 rate = velocity;
  if (deflection.dot(velocity) > 0) {
    const double share = friction::share_of_sliding(law, deflection.norm(), speed, load);
    rate -= share * speed / friction::sliding_deflection(law, speed, load) * deflection;
  }
  return law.stiffness * deflection + friction::damping(law, speed, load) * rate + law.viscosity * velocity;
}

}  // namespace idiophone::contact
