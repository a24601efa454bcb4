#include "idiophone/solids/mesh/plane_region.hpp"

#include <algorithm>

namespace idiophone::mesh {

std::vector<Contour> PlaneRegion::contours() const {
  std::vector<Contour> all = {outline};
  all.insert(all.end(), holes.begin(), holes.end());
  return all;
}

Segment side_of(const Contour& contour, std::size_t side) {
  const auto& polygon = contour.polygon;
  return {Eigen::Vector2d::Map(polygon[side].data()),
          Eigen::Vector2d::Map(polygon[(side + 1) % polygon.size()].data())};
}

double distance(const Eigen::Vector2d& point, const Segment& segment) {
  const Eigen::Vector2d along = segment.to - segment.from;
  const double share = std::clamp(along.dot(point - segment.from) / along.squaredNorm(), 0.0, 1.0);
  return (segment.from + share * along - point).norm();
}

double twice_area(const Point2& a, const Point2& b, const Point2& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

}  // namespace idiophone::mesh
