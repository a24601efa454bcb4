#include "idiophone/air/radiation/diffracting_edge.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace idiophone::radiation {

using std::numbers::pi;

DiffractingEdge DiffractingEdge::turned() const {
  const double cosine = std::cos(angle), sine = std::sin(angle);
  return {begin, end, cosine * face + sine * normal, sine * face - cosine * normal, angle};
}

Vector3 DiffractingEdge::outward() const {
  return std::cos(0.5 * angle) * face + std::sin(0.5 * angle) * normal;
}

std::vector<DiffractingEdge> screen_edges(const std::vector<Vector3>& corners) {
  const Vector3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[1]).normalized();
  std::vector<DiffractingEdge> edges;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector3& end = corners[(i + 1) % corners.size()];
    edges.push_back({corners[i], end, normal.cross(end - corners[i]).normalized(), normal, 2.0 * pi});
  }
  return edges;
}

PlaceAboutEdge seen_from(const DiffractingEdge& edge, const Vector3& point) {
  const Vector3 way = point - edge.begin;
  const Vector3 along = edge.direction();
  double angle = std::atan2(way.dot(edge.normal), way.dot(edge.face));
  if (angle < 0.0) {
    angle += 2.0 * pi;
  }
  if (angle > edge.angle) {  // on a face, by rounding
    angle = angle > 0.5 * edge.angle + pi ? 0.0 : edge.angle;
  }
  const double place = way.dot(along);
  return {place, (way - place * along).norm(), angle};
}

}  // namespace idiophone::radiation
