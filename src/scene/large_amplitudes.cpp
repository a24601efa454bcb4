#include "idiophone/scene/large_amplitudes.hpp"

#include <algorithm>

namespace idiophone::scene {

bool has_large_amplitudes(const Body& body) {
  return body.modal && body.modal->stretching_tolerance;
}

double stretching_tolerance(std::span<const Body> bodies) {
  const auto of_body = [](const Body& body) { return body.modal->stretching_tolerance.value(); };
  return of_body(*std::ranges::min_element(bodies, {}, of_body));
}

}  // namespace idiophone::scene
