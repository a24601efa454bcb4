#include "bristles.hpp"

#include <algorithm>

#include "idiophone/foundation/friction/elasto_plastic_friction.hpp"

namespace idiophone::contact {

Vector3 bend(const friction::Law& law, const Vector3& deflection, const Vector3& velocity, double load, double step) {
  Vector3 free = deflection + step * velocity;
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

NodeBristles carry(const NodeBristles& bristles, double share) {
  if (share <= bristles.share) {
    return bristles;
  }
  return {bristles.deflection * (bristles.share / share), share};
}

NodeBristles bend(const friction::Law& law, const NodeBristles& bristles, const Vector3& velocity, double load,
                  double share, double step) {
  const NodeBristles before = carry(bristles, share);
  const double given = before.deflection.squaredNorm();
  const double free = (before.deflection + step * velocity).squaredNorm();
  const double bent_by = free > given ? share + (before.share - share) * (given / free) : before.share;
  return {bend(law, before.deflection, velocity, load, step), bent_by};
}

Vector3 force_of_bristles(const friction::Law& law, const Vector3& deflection, const Vector3& velocity, double load) {
  const double speed = velocity.norm();
  Vector3 rate = velocity;
  if (deflection.dot(velocity) > 0) {
    const double share = friction::share_of_sliding(law, deflection.norm(), speed, load);
    rate -= share * speed / friction::sliding_deflection(law, speed, load) * deflection;
  }
  return law.stiffness * deflection + friction::damping(law, speed, load) * rate +
         friction::viscosity(law, speed, load) * velocity;
}

}  // namespace idiophone::contact
