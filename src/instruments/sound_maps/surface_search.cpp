#include "idiophone/instruments/sound_maps/surface_search.hpp"

#include <cmath>

namespace idiophone::sound_maps {

namespace {

mesh::TrianglePoints corners_of(const SoundMap& map, const std::array<Index, 3>& triangle) {
  const auto& [i, j, k] = triangle;
  return {map.vertices[i], map.vertices[j], map.vertices[k]};
}

SurfacePoint point_of(const mesh::TrianglePoints& corners, std::size_t triangle, const Vector3& place) {
  const Vector3 weights = mesh::nearest_weights(corners, place);
  return {triangle, weights, (mesh::at_weights(corners, weights) - place).norm()};
}

/// As Eigen::BVMinimize() asks for it. Of triangles that are equally near, the first one is taken.
struct NearestSoFar {
  using Scalar = double;

  // A box counts as a little nearer than it is, so that rounding leaves out no triangle that is as near as another.
  double minimumOnVolume(const Eigen::AlignedBox3d& box) const {
    return (1.0 - 1e-9) * box.exteriorDistance(place) - 1e-12;
  }

  double minimumOnObject(std::size_t triangle) {
    const SurfacePoint point = point_of(triangles[triangle], triangle, place);
    if (point.distance < nearest.distance || (point.distance == nearest.distance && triangle < nearest.triangle)) {
      nearest = point;
    }
    return point.distance;
  }

  const std::vector<mesh::TrianglePoints>& triangles;
  const Vector3& place;
  SurfacePoint nearest{};
};

}  // namespace

SurfacePoint nearest_point(const SoundMap& map, const Vector3& place) {
  SurfacePoint nearest;
  for (std::size_t triangle = 0; triangle < map.triangles.size(); ++triangle) {
    const SurfacePoint point = point_of(corners_of(map, map.triangles[triangle]), triangle, place);
    nearest = point.distance < nearest.distance ? point : nearest;
  }
  return nearest;
}

SurfaceSearch::SurfaceSearch(const SoundMap& map) {
  std::vector<std::size_t> numbers;
  std::vector<Eigen::AlignedBox3d> boxes;
  for (const std::array<Index, 3>& triangle : map.triangles) {
    numbers.push_back(triangles_.size());
    const mesh::TrianglePoints& corners = triangles_.emplace_back(corners_of(map, triangle));
    boxes.push_back(Eigen::AlignedBox3d(corners[0]).extend(corners[1]).extend(corners[2]));
  }
  tree_.init(numbers.begin(), numbers.end(), boxes.begin(), boxes.end());
}

SurfacePoint SurfaceSearch::nearest(const Vector3& place) const {
  NearestSoFar search{.triangles = triangles_, .place = place};
  Eigen::BVMinimize(tree_, search);
  return search.nearest;
}

}  // namespace idiophone::sound_maps
