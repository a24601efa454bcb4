#include "idiophone/air/surface/spread_radii.hpp"

#include <algorithm>

#include "idiophone/air/surface/equivalent_radius.hpp"

namespace idiophone::surface {

std::vector<double> spread_radii(std::span<const Index> triangle_ids, std::span<const Index> first_triangle,
                                 const SurfaceOfBody& surface_of) {
  std::vector<double> radii;
  auto next = triangle_ids.begin();
  for (std::size_t body = 0; body + 1 < first_triangle.size(); ++body) {
    const auto surface = surface_of(body);
    std::vector<Index> here;
    for (; next != triangle_ids.end() && *next < first_triangle[body + 1]; ++next) {
      here.push_back(*next - first_triangle[body]);
    }
    std::ranges::copy(surface::equivalent_radii(surface, here), std::back_inserter(radii));
  }
  return radii;
}

}  // namespace idiophone::surface
