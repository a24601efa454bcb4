#include "idiophone/instruments/resonators/bow.hpp"

#include <algorithm>
#include <cmath>

namespace idiophone::resonators {

Bow::Bow(const score::Bow& bow, int rate) : bow_(bow), step_(1.0 / rate), friction_(bow.friction, step_) {}

ContactMotion Bow::motion() const {
  if (lead_) {
    const double share = std::min(1.0, static_cast<double>(now_ - lead_->begin) / static_cast<double>(lead_->samples));
    return {std::lerp(lead_->from.speed, lead_->to.speed, share), std::lerp(lead_->from.load, lead_->to.load, share)};
  }
  const double time = (static_cast<double>(now_) + 0.5) * step_;
  return {bow_.speed.at(time), bow_.load_at(time)};
}

void Bow::lead(const ContactMotion& wanted, std::int64_t samples) {
  lead_ = Lead{.from = motion(), .to = wanted, .begin = now_, .samples = samples};
}

double Bow::force(double free, double compliance) const {
  const ContactMotion now = motion();
  const double velocity = friction_.velocity(now.speed - free / step_, compliance / step_, now.load);
  return friction_.force(velocity, now.load);
}

void Bow::advance(double way, double /*force*/) {
  const ContactMotion now = motion();
  friction_.advance(now.speed - way / step_, now.load);
  ++now_;
}

}  // namespace idiophone::resonators
