#include "idiophone/foundation/friction/elasto_plastic_friction.hpp"

#include <algorithm>
#include <cmath>

#include "idiophone/foundation/bracketed_root.hpp"

namespace idiophone::friction {

namespace {

double break_away_deflection(const Law& law, double load) {
  return law.break_away * load * law.sliding / law.stiffness;
}

}  // namespace

double sliding_deflection(const Law& law, double speed, double load) {
  const double ratio = speed / law.stribeck_speed;
  const double coefficient = law.sliding + (law.sticking - law.sliding) * std::exp(-ratio * ratio);
  return load * coefficient / law.stiffness;
}

double share_of_sliding(const Law& law, double deflection, double speed, double load) {
  const double breaks = break_away_deflection(law, load);
  return std::clamp((deflection - breaks) / (sliding_deflection(law, speed, load) - breaks), 0.0, 1.0);
}

double bent(const Law& law, double before, double way, double speed, double load) {
  const double free = before + way;
  const double sliding = sliding_deflection(law, speed, load);
  const double breaks = break_away_deflection(law, load);
  if (free <= breaks) {
    return free;
  }
  if (before >= sliding) {
    return free * sliding / (sliding + way);
  }
  const double square = way / (sliding * (sliding - breaks)), linear = 1.0 - square * breaks;
  return 2.0 * free / (linear + std::sqrt(linear * linear + 4.0 * square * free));
}

double damping(const Law& law, double speed, double load) {
  return law.damping / (1.0 + 0.25 * law.damping * speed / (law.sliding * load));
}

double viscosity(const Law& law, double speed, double load) {
  return law.viscosity * speed > law.sticking * load ? law.sticking * load / speed : law.viscosity;
}

ElastoPlasticFriction::ElastoPlasticFriction(const Law& law, double step, Deflection deflection)
    : law_(law), share_(deflection == Deflection::mean ? 0.5 : 1.0), reach_(share_ * step) {}

double ElastoPlasticFriction::used_deflection(double velocity, double load) const {
  const double sign = velocity < 0.0 ? -1.0 : 1.0, speed = std::abs(velocity);
  return sign * bent(law_, sign * deflection_, reach_ * speed, speed, load);
}

double ElastoPlasticFriction::force(double velocity, double load) const {
  if (load <= 0.0) {
    return 0.0;
  }
  const double used = used_deflection(velocity, load);
  const double rate = (used - deflection_) / reach_;
  const double speed = std::abs(velocity);
  return law_.stiffness * used + damping(law_, speed, load) * rate + viscosity(law_, speed, load) * velocity;
}

double ElastoPlasticFriction::velocity(double free, double mobility, double load) const {
  return root_from([&](double tried) { return tried - free + mobility * force(tried, load); }, velocity_);
}

void ElastoPlasticFriction::advance(double velocity, double load) {
  velocity_ = velocity;
  deflection_ = load > 0.0 ? (used_deflection(velocity, load) - (1.0 - share_) * deflection_) / share_ : 0.0;
}

}  // namespace idiophone::friction
