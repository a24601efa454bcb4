#include "idiophone/air/surface/spread_radii.hpp"

#include <algorithm>

#include "idiophone/air/surface/equivalent_radius.hpp"

namespace idiophone::surface {

std::vector<double> spread_radii(std::span<const Index> triangle_ids, std::span<const Index> first_triangle,
                                 const SurfaceOfBody& surface_of, std::span<const std::size_t> inside) {
  std::vector<double> radii;
  auto next = triangle_ids.begin();
  for (std::size_t body = 0; body + 1 < first_triangle.size(); ++body) {
    const auto surface = surface_of(body);
    const std::size_t outside = surface.size() - (inside.empty() ? 0 : inside[body]);
    std::vector<Index> outer, inner;
    for (; next != triangle_ids.end() && *next < first_triangle[body + 1]; ++next) {
      const Index number = *next - first_triangle[body];
      (number < static_cast<Index>(outside) ? outer : inner).push_back(number);
    }
    std::ranges::copy(equivalent_radii(std::span(surface).first(outside), outer), std::back_inserter(radii));
    std::ranges::copy(equivalent_radii(surface, inner), std::back_inserter(radii));
  }
  return radii;
}

}  // namespace idiophone::surface
