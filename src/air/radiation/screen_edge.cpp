#include "idiophone/air/radiation/screen_edge.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace idiophone::radiation {

namespace {

using std::numbers::pi;

constexpr double mirror_fades_over = 0.1;  // of the distance: detour

/// @param detoured  L, m
/// @param distance  R, m; at most L
EdgeWave edge_wave(double detoured, double distance, double speed) {
  const double across = std::sqrt(std::max(0.0, (detoured - distance) * (detoured + distance)));
  const double low = 2.0 / pi * std::atan2(distance, across);
  const double high = 2.0 * distance / std::sqrt(2.0 * detoured * (detoured + distance));
  const double gain = std::pow(low, 0.6) * std::pow(high, 0.4);  // in between, as well
  const double narrow = gain / high;
  return {gain * detoured / distance, (detoured - distance) / speed * narrow * narrow};
}

}  // namespace

std::vector<ScreenEdge> screen_edges(const std::vector<Vector3>& corners) {
  const Vector3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[1]).normalized();
  std::vector<ScreenEdge> edges;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector3& end = corners[(i + 1) % corners.size()];
    edges.push_back({corners[i], end, (end - corners[i]).cross(normal).normalized(), normal});
  }
  return edges;
}

Bend find_bend(const ScreenEdge& edge, const Vector3& source, const Vector3& receiver, double speed) {
  Bend bend;
  const double length = (edge.end - edge.begin).norm();
  const Vector3 along = (edge.end - edge.begin) / length;
  const auto seen_from_edge = [&](const Vector3& point) {
    const Vector3 way = point - edge.begin;
    const double place = way.dot(along);
    return std::pair(place, (way - place * along).norm());
  };
  const auto [source_place, source_radius] = seen_from_edge(source);
  const auto [receiver_place, receiver_radius] = seen_from_edge(receiver);
  const double radii = source_radius + receiver_radius;
  const double distance = (receiver - source).norm();
  if (!(std::min({source_radius, receiver_radius, distance}) > 1e-6 * length)) {
    return bend;  // on the edge
  }
  const double place = source_place + (receiver_place - source_place) * source_radius / radii;
  const double source_height = (source - edge.begin).dot(edge.normal);
  const double receiver_height = (receiver - edge.begin).dot(edge.normal);
  bend.apex = edge.begin + place * along;
  bend.exists = place >= 0.0 && place < length && source_height * receiver_height < 0.0;
  if (!bend.exists) {
    return bend;
  }
  const double detoured = std::hypot(radii, receiver_place - source_place);
  const Vector3 image = source - 2.0 * source_height * edge.normal;
  bend.direct = edge_wave(detoured, distance, speed);
  bend.mirrored = edge_wave(detoured, (receiver - image).norm(), speed);
  const Vector3 crossing =
      source + (receiver - source) * source_height / (source_height - receiver_height);  // of the screen's plane
  if ((crossing - edge.begin).dot(edge.outward) > 0.0) {  // the half-plane does not hide the source
    bend.direct.gain = -bend.direct.gain;
    bend.mirrored.gain *= std::max(0.0, 1.0 - (detoured - distance) / (mirror_fades_over * distance));
  }
  return bend;
}

double edge_response(double time, double delay) {
  return std::atan(std::sqrt(time / delay)) / pi;
}

}  // namespace idiophone::radiation
