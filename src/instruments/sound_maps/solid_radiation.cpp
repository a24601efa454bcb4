#include "idiophone/instruments/sound_maps/solid_radiation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "idiophone/air/harmonic/boundary_elements.hpp"
#include "idiophone/solids/joints/exposed_surface.hpp"

namespace idiophone::sound_maps {

namespace {

/// About what boundary elements take on one core for the modes that the mesh resolves, s.
double boundary_element_time(const SoundMap& map) {
  const auto modes = std::ranges::upper_bound(map.frequency, resolved_frequency(map)) - map.frequency.begin();
  return static_cast<double>(modes) * harmonic::solution_time(map.vertices.size());
}

}  // namespace

SolidRadiation solid_radiation(const SoundMap& map, const scene::Radiation& radiation,
                               std::optional<SurfaceModel> wanted) {
  if (!joints::is_closed(map.triangles)) {
    const std::string open = fmt::format(
        "the surface of {} and the bodies joined to it is open at the borders of joints, as the meshes do not meet "
        "vertex "
        "by vertex there",
        map.body);
    if (wanted == SurfaceModel::boundary_elements) {
      throw std::invalid_argument("boundary elements: " + open + "; leave out --radiation, or make the meshes match");
    }
    return {sphere_patches(map, radiation), "kirchhoff",
            wanted ? "" : "model kirchhoff, whose levels can be wrong by 10 dB: " + open};
  }
  constexpr double longest_by_default = 120.0;  // s
  const double time = boundary_element_time(map);
  const bool is_quick = time <= longest_by_default;
  if (wanted.value_or(is_quick ? SurfaceModel::boundary_elements : SurfaceModel::kirchhoff) ==
      SurfaceModel::kirchhoff) {
    const std::string doubt = fmt::format(
        "model kirchhoff, whose levels can be wrong by 10 dB; boundary elements would take about {:.0f} "
        "min on one core: choose a coarser mesh, fewer modes, or --radiation boundary_elements",
        time / 60.0);
    return {sphere_patches(map, radiation), "kirchhoff", wanted ? "" : doubt};
  }
  SolidRadiation result{boundary_elements(map, radiation), "boundary_elements", ""};
  if (const double resolved = resolved_frequency(map); map.frequency.back() > resolved) {
    result.name = fmt::format("boundary_elements up to {:.0f} Hz, kirchhoff above", resolved);
    result.doubt = result.name + "; a finer mesh raises the limit, which is three edges in a wave length";
  }
  return result;
}

}  // namespace idiophone::sound_maps
