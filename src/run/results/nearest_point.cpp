#include "nearest_point.hpp"

#include <algorithm>
#include <iterator>
#include <limits>

namespace idiophone::results {

NearestPoint::NearestPoint(const std::vector<Vector3>& points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].allFinite()) {
      points_.push_back({points[i], static_cast<std::int64_t>(i)});
    }
  }
  std::ranges::stable_sort(points_, {}, [](const Point& point) { return point.place.x(); });
}

std::int64_t NearestPoint::to(const Vector3& place) const {
  std::int64_t number = -1;
  double least = std::numeric_limits<double>::infinity();
  const auto consider = [&](const Point& point) {
    if (const double square = (point.place - place).squaredNorm(); square < least) {
      least = square;
      number = point.number;
    }
  };
  const auto may_be_nearer = [&](const Point& point) {
    const double along_x = point.place.x() - place.x();
    return along_x * along_x < least;
  };
  auto above = std::ranges::lower_bound(points_, place.x(), {}, [](const Point& point) { return point.place.x(); });
  auto below = above;
  while (true) {
    const bool upwards = above != points_.end() && may_be_nearer(*above);
    const bool downwards = below != points_.begin() && may_be_nearer(*std::prev(below));
    if (!upwards && !downwards) {
      return number;
    }
    if (upwards) {
      consider(*above++);
    }
    if (downwards) {
      consider(*--below);
    }
  }
}

}  // namespace idiophone::results
