#include "idiophone/air/radiation/diffracting_edge.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace idiophone::radiation {

namespace {

using std::numbers::pi;

constexpr double fades_over = 0.1;  // of the distance: detour
constexpr double on_edge = 1e-6;    // of its length

/// A point in cylindrical coordinates about an edge.
struct FromEdge {
  double along;   // m
  double radius;  // m
  double angle;   // from the first face, 0 to the edge's
};

Vector3 direction_of(const DiffractingEdge& edge) {
  return (edge.end - edge.begin).normalized();
}

FromEdge seen_from(const DiffractingEdge& edge, const Vector3& point) {
  const Vector3 way = point - edge.begin;
  const Vector3 along = direction_of(edge);
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

/// The way from a source to a receiver by way of an edge.
struct EdgeWay {
  double source_radius, receiver_radius;  // m
  double along;                           // from source to receiver, m

  [[nodiscard]] double length() const { return std::hypot(source_radius + receiver_radius, along); }
  /// Of two points that an angle is between.
  [[nodiscard]] double distance(double angle) const {
    const double plane = source_radius * source_radius + receiver_radius * receiver_radius -
                         2.0 * source_radius * receiver_radius * std::cos(angle);
    return std::sqrt(std::max(0.0, plane) + along * along);
  }
  /// What is left of the waves where there is no shadow: 1 where the shadow begins.
  [[nodiscard]] double fade(double angle) const {
    const double straight = distance(angle);
    return angle > pi ? 1.0 : std::max(0.0, 1.0 - (length() - straight) / (fades_over * straight));
  }
};

/// @param air    angle of the edge
/// @param angle  from the source, or from its image, to the receiver
EdgeWave edge_wave(const EdgeWay& way, double air, double angle, double speed) {
  const double index = pi / air;
  const double length = way.length();
  const double distance = std::max(way.distance(angle), 1e-9 * length);
  const double across = std::sqrt(std::max(0.0, (length - distance) * (length + distance)));
  const double half_plane = 2.0 / pi * std::atan2(distance, across) * length / distance;
  const double gain = std::sqrt(half_plane) * std::pow(2.0 * index, std::pow(across / length, 0.25));
  // The square root of c d for A = 1, m^(1/2); Pierce's X is proportional to it. Negative where the source is in sight.
  const double depth = (std::cos(index * pi) - std::cos(index * angle)) / (index * std::sin(index * pi)) *
                       std::sqrt(0.5 * way.source_radius * way.receiver_radius / length);
  constexpr double grazing = 1e-9;  // where the shadow begins, the source is in sight
  return {depth > grazing ? gain : -gain, std::pow(gain * depth, 2) / speed};
}

bool is_within(const DiffractingEdge& edge, const Vector3& point) {
  const double place = (point - edge.begin).dot(direction_of(edge));
  return place >= 0.0 && place < (edge.end - edge.begin).norm();
}

/// Turns a point about an edge into the plane of the first face, away from that face.
Vector3 unfolded(const DiffractingEdge& edge, const FromEdge& point) {
  return edge.begin + point.along * direction_of(edge) - point.radius * edge.face;
}

}  // namespace

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

Bend find_bend(const DiffractingEdge& edge, const Vector3& source, const Vector3& receiver, double speed) {
  Bend bend;
  const FromEdge from = seen_from(edge, source), to = seen_from(edge, receiver);
  const EdgeWay way{from.radius, to.radius, to.along - from.along};
  const double angle = std::abs(to.angle - from.angle), sum = to.angle + from.angle;
  const double smallest = on_edge * (edge.end - edge.begin).norm();
  if (!(std::min({from.radius, to.radius, way.distance(angle)}) > smallest)) {
    return bend;  // on the edge
  }
  double weight = way.fade(angle);
  if (angle < pi) {  // to nothing where reflections by the faces would begin
    const double first = std::min(to.angle, from.angle), second = edge.angle - std::max(to.angle, from.angle);
    weight *= std::clamp(0.5 * (sum - pi) / std::max(first, 1e-9), 0.0, 1.0) *
              std::clamp(0.5 * (2.0 * edge.angle - pi - sum) / std::max(second, 1e-9), 0.0, 1.0);
  }
  bend.apex = edge.begin + (from.along + way.along * from.radius / (from.radius + to.radius)) * direction_of(edge);
  bend.exists = weight > 0.0 && is_within(edge, bend.apex);
  if (bend.exists) {
    bend.direct = edge_wave(way, edge.angle, angle, speed);
    bend.mirrored = edge_wave(way, edge.angle, sum, speed);
    bend.direct.gain *= weight;
    bend.mirrored.gain *= weight;
  }
  return bend;
}

DoubleBend find_double_bend(const DiffractingEdge& first, const DiffractingEdge& second, const Vector3& source,
                            const Vector3& receiver, double speed) {
  DoubleBend bend;
  const FromEdge from = seen_from(first, source), to = seen_from(second, receiver);
  if (std::min(from.angle, to.angle) < 0.5 * pi || !(std::min(from.radius, to.radius) > 1e-9)) {
    return bend;  // far from any shadow
  }
  const Vector3 begin = unfolded(first, from), end = unfolded(second, to);
  const double beyond_first = (end - first.begin).dot(first.face);
  const double before_second = (begin - second.begin).dot(second.face);
  if (!(beyond_first > 0.0 && before_second > 0.0)) {
    return bend;
  }
  const double one = from.radius / (from.radius + beyond_first);
  const double two = before_second / (to.radius + before_second);
  bend.apexes = {begin + one * (end - begin), begin + two * (end - begin)};
  const EdgeWay first_way{from.radius, beyond_first, (end - begin).dot(direction_of(first))};
  const EdgeWay second_way{before_second, to.radius, (end - begin).dot(direction_of(second))};
  const double weight = first_way.fade(from.angle) * second_way.fade(to.angle);
  bend.exists = one < two && weight > 0.0 && is_within(first, bend.apexes[0]) && is_within(second, bend.apexes[1]);
  if (bend.exists) {
    const EdgeWave before = edge_wave(first_way, first.angle, from.angle, speed);
    const EdgeWave after = edge_wave(second_way, second.angle, to.angle, speed);
    bend.gain = 2.0 * weight * before.gain * after.gain;  // half of the waves is the image's on the face between
    bend.delays = {before.delay, after.delay};
    *std::ranges::min_element(bend.delays) *= (two - one) / (two * (1.0 - one));  // Pierce's B squared
  }
  return bend;
}

double edge_response(double time, double delay) {
  return std::atan(std::sqrt(time / delay)) / pi;
}

}  // namespace idiophone::radiation
