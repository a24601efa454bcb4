#pragma once
// The nearest of many points.

#include <cstdint>
#include <vector>

#include "idiophone/foundation/types.hpp"

namespace idiophone::results {

/// Points in the order of their first coordinate, so that a search looks only at a slab around its place: for n points
/// on a surface, some sqrt(n) of them.
class NearestPoint {
 public:
  /// Points that are not finite are never the nearest.
  explicit NearestPoint(const std::vector<Vector3>& points);

  /// Number of the point that is nearest to a place; -1 if there is none, or the place is not finite. The same points
  /// and place give the same answer.
  [[nodiscard]] std::int64_t to(const Vector3& place) const;

 private:
  struct Point {
    Vector3 place;
    std::int64_t number;
  };
  std::vector<Point> points_;
};

}  // namespace idiophone::results
