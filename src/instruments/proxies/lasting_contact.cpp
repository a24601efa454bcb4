#include "idiophone/instruments/proxies/lasting_contact.hpp"

#include <cmath>
#include <numbers>

namespace idiophone::proxies {

Force lasting_contact(std::size_t body, std::int64_t start, const Vector3& at, const Vector3& impulse, int samples,
                      int rate) {
  Force force{.body = body, .start = start, .at = at, .direction = impulse, .curve = {}};
  for (int i = 0; i < 2 * samples; ++i) {
    const double window = 0.5 - 0.5 * std::cos(std::numbers::pi * (i + 0.5) / samples);
    force.curve.push_back(window * rate / samples);
  }
  return force;
}

}  // namespace idiophone::proxies
