#include "idiophone/air/radiation/bend.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace idiophone::radiation {

namespace {

using std::numbers::pi;

constexpr double fades_over = 0.1;  // of the distance: detour
constexpr double on_edge = 1e-6;    // of its length
constexpr double far_from_shadow = 0.5 * pi;

/// The way at an edge, as if it went straight before and after.
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

/// To nothing where reflections by the faces would begin.
double fade_to_reflections(const DiffractingEdge& edge, double source_angle, double receiver_angle) {
  const auto [low, high] = std::minmax(source_angle, receiver_angle);
  const double sum = low + high;
  return std::clamp(0.5 * (sum - pi) / std::max(low, 1e-9), 0.0, 1.0) *
         std::clamp(0.5 * (2.0 * edge.angle - pi - sum) / std::max(edge.angle - high, 1e-9), 0.0, 1.0);
}

/// A way and its corners: the source, the edges, the receiver.
struct Corners {
  std::array<Vector3, most_in_turn + 2> at;
  std::array<double, most_in_turn + 2> gone = {};  // from the source to a corner, m
  std::size_t last;                                // corner

  Corners(const EdgesInTurn& way, const std::array<Vector3, most_in_turn>& apexes, const Vector3& source,
          const Vector3& receiver)
      : last(way.count + 1) {
    at[0] = source;
    std::ranges::copy(apexes, at.begin() + 1);
    at.at(last) = receiver;
    for (std::size_t i = 0; i < last; ++i) {
      gone.at(i + 1) = gone.at(i) + (at.at(i + 1) - at.at(i)).norm();
    }
  }
  [[nodiscard]] double left(std::size_t corner) const { return gone.at(last) - gone.at(corner); }
};

/// Adds the waves of an edge.
/// @return  their weight; 0 if there is none
double add_edge(const EdgesInTurn& way, std::size_t number, const Corners& corners, double speed, Bend& bend) {
  const DiffractingEdge& edge = way.edges.at(number);
  const std::size_t here = number + 1;
  const PlaceAboutEdge from = seen_from(edge, corners.at.at(here - 1)), to = seen_from(edge, corners.at.at(here + 1));
  const double place = seen_from(edge, corners.at.at(here)).along;
  const double before = corners.gone.at(here) / (corners.gone.at(here) - corners.gone.at(here - 1));
  const double after = corners.left(here) / (corners.left(here) - corners.left(here + 1));
  const EdgeWay straight{before * from.radius, after * to.radius,
                         before * (place - from.along) + after * (to.along - place)};
  const double angle = std::abs(to.angle - from.angle);
  const double smallest = on_edge * edge.length();
  if (place < 0.0 || !(place < edge.length()) ||
      !(std::min({from.radius, to.radius, straight.distance(angle)}) > smallest) ||
      (way.count > 1 && to.angle - from.angle < far_from_shadow)) {
    return 0.0;
  }
  const bool on_face = (number > 0 && way.over_face.at(number - 1)) || (here < way.count && way.over_face.at(number));
  auto& [direct, mirrored] = bend.waves.at(number);
  direct = edge_wave(straight, edge.angle, angle, speed);
  if (on_face) {
    direct.gain *= 2.0;
    return straight.fade(angle);
  }
  mirrored = edge_wave(straight, edge.angle, to.angle + from.angle, speed);
  return straight.fade(angle) * (angle < pi ? fade_to_reflections(edge, from.angle, to.angle) : 1.0);
}

/// Pierce's B squared of neighbours, and its product over more edges: with it, the wave behind the last edge has spread
/// from each of them.
/// @param included  which edges there are
double spreading(const Corners& corners, const std::array<bool, most_in_turn>& included) {
  double product = 1.0;
  std::size_t before = 0;  // corner
  for (std::size_t here = 1; here < corners.last; ++here) {
    if (!included.at(here - 1)) {
      continue;
    }
    if (before > 0) {
      product *= corners.gone.at(corners.last) * (corners.gone.at(here) - corners.gone.at(before)) /
                 (corners.left(before) * corners.gone.at(here));
    }
    before = here;
  }
  return product;
}

/// Edges count in the order of their delays, the longest first. So an edge that has none changes nothing for the
/// others.
void shorten_delays(const Corners& corners, Bend& bend) {
  std::array<std::size_t, most_in_turn> order = {0, 1, 2};
  std::ranges::stable_sort(order, std::greater(), [&](std::size_t edge) { return bend.waves.at(edge)[0].delay; });
  std::array<bool, most_in_turn> included = {};
  double before = 1.0;
  for (const std::size_t edge : order) {
    included.at(edge) = edge + 1 < corners.last;
    const double with = spreading(corners, included);
    for (EdgeWave& wave : bend.waves.at(edge)) {
      wave.delay *= with / before;
    }
    before = with;
  }
}

}  // namespace

Bend find_bend(const EdgesInTurn& way, const Vector3& source, const Vector3& receiver, double speed) {
  Bend bend;
  const std::span edges(way.edges.data(), way.count);
  if (way.count > 1 && (edges.front().angle - seen_from(edges.front(), source).angle < far_from_shadow ||
                        seen_from(edges.back(), receiver).angle < far_from_shadow)) {
    return bend;  // soon known for most ways
  }
  bend.apexes = shortest_way(edges, source, receiver);
  const Corners corners(way, bend.apexes, source, receiver);
  double gain = 1.0;
  for (std::size_t number = 0; number < way.count && gain > 0.0; ++number) {
    gain *= add_edge(way, number, corners, speed, bend);
  }
  for (const bool over_face : way.over_face) {
    gain *= over_face ? 0.5 : 1.0;  // the other half is the reflection by that face
  }
  shorten_delays(corners, bend);
  bend.gain = gain;
  return bend;
}

double edge_response(double time, double delay) {
  return std::atan(std::sqrt(time / delay)) / pi;
}

}  // namespace idiophone::radiation
