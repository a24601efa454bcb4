#include "idiophone/air/radiation/shortest_way.hpp"

#include <Eigen/Dense>
#include <algorithm>

namespace idiophone::radiation {

namespace {

/// From the begin of each edge to the point where the way touches its line, m.
using Places = Eigen::Vector3d;
static_assert(most_in_turn == 3);

/// A way by places on edges.
class Way {
 public:
  Way(std::span<const DiffractingEdge> edges, const Vector3& source, const Vector3& receiver)
      : edges_(edges), source_(source), receiver_(receiver) {
    std::ranges::transform(edges, directions_.begin(), &DiffractingEdge::direction);
  }

  [[nodiscard]] std::size_t count() const { return edges_.size(); }
  [[nodiscard]] const Vector3& direction(std::size_t edge) const { return directions_.at(edge); }

  /// Corner 0 is the source, then come the edges, and then the receiver.
  [[nodiscard]] Vector3 corner(std::size_t number, const Places& places) const {
    if (number == 0 || number > count()) {
      return number == 0 ? source_ : receiver_;
    }
    const std::size_t edge = number - 1;
    return edges_[edge].begin + places[static_cast<Eigen::Index>(edge)] * directions_.at(edge);
  }

  [[nodiscard]] double length(const Places& places) const {
    double sum = 0.0;
    for (std::size_t part = 0; part <= count(); ++part) {
      sum += (corner(part + 1, places) - corner(part, places)).norm();
    }
    return sum;
  }

  /// Where an edge is best touched between the corners before and after it.
  [[nodiscard]] double best_place(std::size_t edge, const Places& places) const {
    const PlaceAboutEdge before = seen_from(edges_[edge], corner(edge, places));
    const PlaceAboutEdge after = seen_from(edges_[edge], corner(edge + 2, places));
    const double radii = before.radius + after.radius;
    return radii > 0.0 ? before.along + (after.along - before.along) * before.radius / radii : before.along;
  }

 private:
  std::span<const DiffractingEdge> edges_;
  Vector3 source_, receiver_;
  std::array<Vector3, most_in_turn> directions_;
};

/// How the length of a way changes with the places.
struct Slope {
  Places gradient = Places::Zero();
  Eigen::Matrix3d curvature = Eigen::Matrix3d::Zero();  // 1/m
  /// That of the sum of the squares of the parts, each over twice its length: not less than `curvature`.
  Eigen::Matrix3d bound = Eigen::Matrix3d::Zero();
};

Slope slope_of(const Way& way, const Places& places) {
  constexpr double shortest = 1e-9;  // of a part, m
  Slope slope;
  for (std::size_t part = 0; part <= way.count(); ++part) {
    const Vector3 step = way.corner(part + 1, places) - way.corner(part, places);
    const double length = std::max(step.norm(), shortest);
    // The part ends on edge `part` and begins on the one before.
    Eigen::Matrix3d ends = Eigen::Matrix3d::Zero();
    if (part < way.count()) {
      ends.col(static_cast<Eigen::Index>(part)) = way.direction(part);
    }
    if (part > 0) {
      ends.col(static_cast<Eigen::Index>(part) - 1) = -way.direction(part - 1);
    }
    const Eigen::Vector3d change = ends.transpose() * step / length;
    slope.gradient += change;
    slope.bound += ends.transpose() * ends / length;
    slope.curvature += (ends.transpose() * ends - change * change.transpose()) / length;
  }
  for (auto unused = static_cast<Eigen::Index>(way.count()); unused < 3; ++unused) {
    slope.curvature(unused, unused) = slope.bound(unused, unused) = 1.0;
  }
  return slope;
}

}  // namespace

std::array<Vector3, most_in_turn> shortest_way(std::span<const DiffractingEdge> edges, const Vector3& source,
                                               const Vector3& receiver) {
  constexpr double near = 1e-9;  // of the way's length
  constexpr int most_steps = 50;
  const Way way(edges, source, receiver);
  Places places = Places::Zero();
  for (std::size_t edge = 0; edge < edges.size(); ++edge) {
    places[static_cast<Eigen::Index>(edge)] = 0.5 * edges[edge].length();
  }
  for (std::size_t edge = 0; edge < edges.size(); ++edge) {
    places[static_cast<Eigen::Index>(edge)] = way.best_place(edge, places);  // the answer if there is only one
  }
  double length = way.length(places);
  for (int step = 0; edges.size() > 1 && step < most_steps; ++step) {
    const Slope slope = slope_of(way, places);
    Places change = -slope.curvature.ldlt().solve(slope.gradient);
    if (!(way.length(places + change) <= length)) {  // too far: the bound never is
      change = -slope.bound.ldlt().solve(slope.gradient);
    }
    places += change;
    length = way.length(places);
    if (!(change.norm() > near * length)) {
      break;
    }
  }
  std::array<Vector3, most_in_turn> touched = {source, source, source};
  for (std::size_t edge = 0; edge < edges.size(); ++edge) {
    touched.at(edge) = way.corner(edge + 1, places);
  }
  return touched;
}

}  // namespace idiophone::radiation
