#include <fmt/format.h>

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <iterator>

#include "idiophone/instruments/sound_maps/sound_map.hpp"
#include "idiophone/solids/eigenmodes/is_rigid_motion.hpp"

namespace idiophone::sound_maps {

std::string mesh_error_text(const SoundMap& map) {
  if (map.mesh_error.empty()) {
    return {};
  }
  const Eigen::Map<const Eigen::Matrix3Xd> places(map.vertices.front().data(), 3, std::ssize(map.vertices));
  std::size_t bending = 0, known = 0, largest = 0;
  for (std::size_t mode = 0; mode < map.mesh_error.size(); ++mode) {
    // A body that swings on soft supports has no pitch, and their patches change with the mesh.
    const Eigen::Map<const Eigen::Matrix3Xf> shape(map.shape_of(mode).data(), 3, places.cols());
    if (eigenmodes::is_rigid_motion(places, shape.cast<double>())) {
      continue;
    }
    ++bending;
    if (std::isnan(map.mesh_error[mode])) {
      continue;
    }
    if (known++ == 0 || std::abs(map.mesh_error[mode]) > std::abs(map.mesh_error[largest])) {
      largest = mode;
    }
  }
  if (known == 0) {
    return {};
  }
  const std::size_t rigid = map.modes() - bending;
  return fmt::format(
      "the mesh makes frequencies wrong by up to {:.1f} cents (mode {}), as estimated for {} of {} modes{}",
      std::abs(map.mesh_error[largest]), largest + 1, known, bending,
      rigid > 0 ? fmt::format(" besides {} rigid motion{}", rigid, rigid == 1 ? "" : "s") : "");
}

}  // namespace idiophone::sound_maps
