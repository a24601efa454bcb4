#pragma once
// A bar that breaks.

#include <cmath>
#include <memory>
#include <vector>

#include "bodies.hpp"
#include "idiophone/instruments/proxies/fracture.hpp"

namespace idiophone::proxies {

inline constexpr double bar_length = 0.3, bar_width = 0.03;  // m

/// A bar along x. @param neck  how thin it is in the middle, of its bar_width
inline std::shared_ptr<const Lattice> bar(double neck = 1.0, const Damping& damping = {}) {
  const auto place = [neck](const Vector3& at) {
    const double thickness = std::abs(at[0] - 0.5) < 0.04 ? neck : 1.0;
    return Vector3(bar_length * at[0], bar_width * thickness * (at[1] - 0.5), bar_width * thickness * (at[2] - 0.5));
  };
  return std::make_shared<Lattice>(grid_mesh({10, 1, 1}, place),
                                   Material{.young = 1e8, .density = 1000.0, .damping = damping});
}

/// A state in which every cross-section has moved along x.
template <class Displacement>
Fragment stretched(const std::shared_ptr<const Lattice>& lattice, const Displacement& displacement) {
  Fragment fragment{.lattice = lattice, .displacement = {}, .velocity = {}};
  for (const Vector3& node : lattice->mesh().nodes) {
    fragment.displacement.emplace_back(displacement(node.x()), 0.0, 0.0);
    fragment.velocity.emplace_back(Vector3::Zero());
  }
  return fragment;
}

/// Everything that is overloaded breaks, while it does not move.
inline std::vector<Fragment> all_broken(const Fragment& whole, const Strength& strength) {
  std::vector<Fragment> left = {whole}, held;
  for (int breaks = 0; !left.empty() && breaks < 5000; ++breaks) {
    const Fragment next = left.back();
    left.pop_back();
    const std::vector<Overload> overloaded = overloads(next, strength);
    std::vector<Fragment> parts = overloaded.empty() ? std::vector{next} : broken(next, overloaded);
    auto& place = overloaded.empty() ? held : left;
    place.insert(place.end(), parts.begin(), parts.end());
  }
  held.insert(held.end(), left.begin(), left.end());
  return held;
}

}  // namespace idiophone::proxies
