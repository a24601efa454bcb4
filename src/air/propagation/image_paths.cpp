#include "idiophone/air/propagation/image_paths.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace idiophone::propagation {

namespace {

/// @param reflections  along each axis, negative if the last is at the low wall
ImagePath path_in(const scene::Room& room, const std::array<int, 3>& reflections) {
  ImagePath path{.planes = {}, .reflections = 0, .losses = std::vector<double>(scene::OctaveBands().size())};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const int count = reflections.at(axis);
    path.reflections += std::abs(count);
    const Vector3 edge = room.size[static_cast<Eigen::Index>(axis)] * Vector3::Unit(static_cast<Eigen::Index>(axis));
    if (count % 2 == 0) {
      path.shift += count * edge;
    } else {
      path.planes.push_back({.at = room.corner + (count + 1) / 2 * edge, .normal = edge.normalized()});
    }
    // By turns at both walls, the last one first.
    const std::size_t last = 2 * axis + (count > 0 ? 1 : 0);
    for (int left = std::abs(count); left > 0; --left) {
      const std::size_t wall = left % 2 == std::abs(count) % 2 ? last : last ^ 1U;
      path.reflection *= std::sqrt(1.0 - room.absorption.at(wall).front());
      for (std::size_t band = 0; band < path.losses.size(); ++band) {
        path.losses[band] += 0.5 * room.loss(wall, band);
      }
    }
  }
  if (!room.absorbs_evenly()) {
    path.reflection = 1.0;
  }
  return path;
}

std::vector<ImagePath> paths_in(const scene::Room& room) {
  const int order = room.order();
  std::vector<ImagePath> paths;
  for (int x = -order; x <= order; ++x) {
    for (int y = -order; y <= order; ++y) {
      for (int z = -order; z <= order; ++z) {
        const int reflections = std::abs(x) + std::abs(y) + std::abs(z);
        if (reflections > 0 && reflections <= order) {
          paths.push_back(path_in(room, {x, y, z}));
        }
      }
    }
  }
  std::erase_if(paths, [](const ImagePath& path) { return path.reflection == 0.0; });
  return paths;
}

/// Where a point behind floor or walls really is.
Vector3 folded(const scene::Radiation& radiation, Vector3 point) {
  if (const auto& floor = radiation.floor; floor && floor->height(point) < 0.0) {
    return point - 2.0 * floor->height(point) * floor->direction;
  }
  if (const auto& room = radiation.room) {
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const double size = room->size[axis];
      const double place = std::abs(std::remainder(point[axis] - room->corner[axis], 2.0 * size));
      point[axis] = room->corner[axis] + place;
    }
  }
  return point;
}

}  // namespace

Vector3 ImagePath::mirrored(Vector3 direction) const {
  for (const radiation::ReflectingPlane& plane : planes) {
    direction = plane.mirrored(direction);
  }
  return direction;
}

radiation::ReceiverState image(const radiation::ReceiverState& receiver, const ImagePath& path) {
  radiation::ReceiverState state = receiver;
  for (const radiation::ReflectingPlane& plane : path.planes) {
    state = radiation::image(state, plane);
  }
  state.position += path.shift;
  state.gain *= path.reflection;
  return state;
}

std::vector<ImagePath> image_paths(const scene::Radiation& radiation) {
  if (radiation.room) {
    return paths_in(*radiation.room);
  }
  if (const auto& floor = radiation.floor) {
    return {{.planes = {{.at = floor->at, .normal = floor->direction, .reflection = floor->reflection}}}};
  }
  return {};
}

std::vector<Vector3> reflected_way(const scene::Radiation& radiation, const Vector3& source, const Vector3& image) {
  std::vector<double> parts = {0.0, 1.0};  // of the straight way to the image, where it is folded
  if (const auto& floor = radiation.floor) {
    const double before = floor->height(source), after = floor->height(image);
    if (before * after < 0.0) {
      parts.push_back(before / (before - after));
    }
  }
  if (const auto& room = radiation.room) {
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const double begin = (source[axis] - room->corner[axis]) / room->size[axis];
      const double end = (image[axis] - room->corner[axis]) / room->size[axis];
      for (double wall = std::ceil(std::min(begin, end)); wall < std::max(begin, end); wall += 1.0) {
        parts.push_back((wall - begin) / (end - begin));
      }
    }
  }
  std::ranges::sort(parts);
  std::vector<Vector3> way;
  for (const double part : parts) {
    way.push_back(folded(radiation, source + part * (image - source)));
  }
  return way;
}

std::optional<receivers::AbsorbingWalls> absorbing_walls(const scene::Radiation& radiation,
                                                         const std::vector<ImagePath>& images, int rate) {
  if (!radiation.room || radiation.room->absorbs_evenly()) {
    return {};
  }
  std::vector<std::vector<double>> losses = {std::vector<double>(scene::OctaveBands().size())};
  std::ranges::transform(images, std::back_inserter(losses), &ImagePath::losses);
  return receivers::AbsorbingWalls(std::move(losses), scene::lowest_octave, rate);
}

}  // namespace idiophone::propagation
