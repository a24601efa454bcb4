#pragma once
// The nearest point of a surface, for many places.

#include <unsupported/Eigen/BVH>
#include <vector>

#include "idiophone/instruments/sound_maps/blow.hpp"
#include "idiophone/solids/mesh/triangle_point.hpp"

namespace idiophone::sound_maps {

/// The triangles of a map in a hierarchy of bounding boxes: for n triangles, a search looks at some log(n) of them.
class SurfaceSearch {
 public:
  explicit SurfaceSearch(const SoundMap& map);

  /// The same as nearest_point().
  [[nodiscard]] SurfacePoint nearest(const Vector3& place) const;

 private:
  std::vector<mesh::TrianglePoints> triangles_;
  Eigen::KdBVH<double, 3, std::size_t> tree_;  ///< of their numbers
};

}  // namespace idiophone::sound_maps
