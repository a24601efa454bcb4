#include "idiophone/air/propagation/folded_sight.hpp"

#include "idiophone/air/propagation/image_paths.hpp"

namespace idiophone::propagation {

namespace {

constexpr double short_of_a_plane = 1e-6;  // of a part of a way

}  // namespace

bool FoldedSight::sees(Index triangle, const Vector3& end) const {
  if (!section_.floor && !section_.room) {
    return visibility_.sees(triangle, end);
  }
  const Vector3 centre = visibility_.centre(triangle);
  const std::vector<Vector3> way = reflected_way(section_, centre, end);
  if (way.size() == 2) {
    return visibility_.sees(triangle, way.back());
  }
  return visibility_.sees(triangle, way[1] + short_of_a_plane * (centre - way[1])) && is_clear_from(1, way);
}

bool FoldedSight::is_clear(const Vector3& begin, const Vector3& end) const {
  if (!section_.floor && !section_.room) {
    return visibility_.is_clear(begin, end);
  }
  return is_clear_from(0, reflected_way(section_, begin, end));
}

bool FoldedSight::is_in_air(const Vector3& place) const {
  return (!section_.floor || section_.floor->height(place) > 0.0) &&
         (!section_.room || section_.room->distance_outside(place) <= 0.0);
}

bool FoldedSight::is_clear_from(std::size_t part, const std::vector<Vector3>& way) const {
  for (; part + 1 < way.size(); ++part) {
    const Vector3 onwards = way[part + 1] - way[part];
    const Vector3 begin = way[part] + (part > 0 ? short_of_a_plane : 0.0) * onwards;
    const Vector3 end = way[part + 1] - (part + 2 < way.size() ? short_of_a_plane : 0.0) * onwards;
    if (!visibility_.is_clear(begin, end)) {
      return false;
    }
  }
  return true;
}

}  // namespace idiophone::propagation
