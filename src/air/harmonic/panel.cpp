#include "panel.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace idiophone::harmonic {

namespace {

using std::numbers::pi;

/// The places of the shape functions (a, b, b), (b, a, b) and (b, b, a).
std::array<TrianglePoint, 3> orbit(double a, double weight) {
  const double b = (1.0 - a) / 2.0;
  return {{{{a, b, b}, weight}, {{b, a, b}, weight}, {{b, b, a}, weight}}};
}

/// Integrals of the static kernel 1/r over a panel, without 1/(4 pi).
struct StaticPotentials {
  std::array<double, 3> single_layer = {};
  std::array<double, 3> double_layer = {};
};

/// ln((r_2 + s_2)/(r_1 + s_1)) without cancellation: the integral of 1/r along an edge.
double edge_logarithm(double s1, double r1, double s2, double r2) {
  return s1 + s2 >= 0 ? std::log((r2 + s2) / (r1 + s1)) : std::log((r1 - s1) / (r2 - s2));
}

/// Edge by edge; d is the height above the plane, t the distance of the foot from an edge's line, positive inside, s
/// the places of the edge's ends along it.
StaticPotentials static_potentials(const Panel& panel, const Vector3& point) {
  const double height = panel.normal.dot(point - panel.corners[0]);
  const double above = std::abs(height);
  const Vector3 winding = (panel.corners[1] - panel.corners[0]).cross(panel.corners[2] - panel.corners[0]);
  const double turn = winding.dot(panel.normal) < 0 ? -1.0 : 1.0;  // a mirror image runs clockwise
  double single = 0.0;
  double angle = 0.0;                       // solid angle
  Vector3 single_moment = Vector3::Zero();  // of (y - foot)/r
  Vector3 double_moment = Vector3::Zero();  // of (y - foot)/r^3
  for (std::size_t corner = 0; corner < 3; ++corner) {
    const Vector3 first = panel.corners.at(corner) - point;
    const Vector3 second = panel.corners.at((corner + 1) % 3) - point;
    const Vector3 along = (second - first).normalized();
    const Vector3 outward = turn * along.cross(panel.normal);
    const double t = outward.dot(first);
    const double s1 = along.dot(first);
    const double s2 = along.dot(second);
    const double r1 = first.norm();
    const double r2 = second.norm();
    const double square = t * t + height * height;
    const double logarithm = edge_logarithm(s1, r1, s2, r2);
    const double arc = std::atan2(t * s2, square + above * r2) - std::atan2(t * s1, square + above * r1);
    single += t * logarithm - above * arc;
    angle += arc;
    single_moment += 0.5 * (square * logarithm + s2 * r2 - s1 * r1) * outward;
    double_moment -= logarithm * outward;
  }
  const bool is_on_panel = above < 1e-9 * panel.radius;
  const double signed_angle = height < 0 ? -angle : angle;
  StaticPotentials potentials;
  for (std::size_t b = 0; b < 3; ++b) {
    const double foot = 1.0 + panel.gradients.at(b).dot(point - panel.corners.at(b));
    potentials.single_layer.at(b) = foot * single + panel.gradients.at(b).dot(single_moment);
    potentials.double_layer.at(b) =
        is_on_panel ? 0.0 : foot * signed_angle + height * panel.gradients.at(b).dot(double_moment);
  }
  return potentials;
}

}  // namespace

Panel::Panel(std::array<Vector3, 3> places) : corners(std::move(places)) {
  const Vector3 twice = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  area = twice.norm() / 2.0;
  normal = twice.normalized();
  centre = (corners[0] + corners[1] + corners[2]) / 3.0;
  for (std::size_t b = 0; b < 3; ++b) {
    const Vector3 opposite = corners.at((b + 2) % 3) - corners.at((b + 1) % 3);
    gradients.at(b) = normal.cross(opposite) / (2.0 * area);
    radius = std::max(radius, (corners.at(b) - centre).norm());
  }
}

Panel mirrored(const Panel& panel, const radiation::ReflectingPlane& plane) {
  Panel image = panel;
  for (std::size_t b = 0; b < 3; ++b) {
    image.corners.at(b) = plane.at + plane.mirrored(panel.corners.at(b) - plane.at);
    image.gradients.at(b) = plane.mirrored(panel.gradients.at(b));
  }
  image.centre = plane.at + plane.mirrored(panel.centre - plane.at);
  image.normal = plane.mirrored(panel.normal);
  return image;
}

std::span<const TrianglePoint> triangle_rule_2() {
  static const auto points = orbit(2.0 / 3.0, 1.0 / 3.0);
  return points;
}

std::span<const TrianglePoint> triangle_rule_5() {
  static const auto points = [] {
    const double root = std::sqrt(15.0);
    const auto inner = orbit((9.0 + 2.0 * root) / 21.0, (155.0 - root) / 1200.0);
    const auto outer = orbit((9.0 - 2.0 * root) / 21.0, (155.0 + root) / 1200.0);
    return std::array<TrianglePoint, 7>{
        {{Vector3::Constant(1.0 / 3.0), 9.0 / 40.0}, inner[0], inner[1], inner[2], outer[0], outer[1], outer[2]}};
  }();
  return points;
}

LayerPotentials quadrature_potentials(const Panel& panel, const Vector3& point, double wave_number,
                                      std::span<const TrianglePoint> rule) {
  LayerPotentials potentials;
  for (const TrianglePoint& q : rule) {
    const Vector3 way = point - panel.at(q.shape);
    const double r = way.norm();
    const double phase = wave_number * r;
    const double scale = q.weight * panel.area / (4.0 * pi * r);
    const std::complex<double> green(scale * std::cos(phase), -scale * std::sin(phase));
    const double slope = panel.normal.dot(way) / (r * r);
    const std::complex<double> derivative(slope * (green.real() - phase * green.imag()),
                                          slope * (green.imag() + phase * green.real()));
    for (std::size_t b = 0; b < 3; ++b) {
      potentials.single_layer.at(b) += q.shape[b] * green;
      potentials.double_layer.at(b) += q.shape[b] * derivative;
    }
  }
  return potentials;
}

LayerPotentials near_potentials(const Panel& panel, const Vector3& point, double wave_number) {
  const StaticPotentials singular = static_potentials(panel, point);
  LayerPotentials potentials;
  for (std::size_t b = 0; b < 3; ++b) {
    potentials.single_layer.at(b) = singular.single_layer.at(b) / (4.0 * pi);
    potentials.double_layer.at(b) = singular.double_layer.at(b) / (4.0 * pi);
  }
  const double smallest = 1e-9 * panel.radius;
  for (const TrianglePoint& q : triangle_rule_5()) {
    const Vector3 way = point - panel.at(q.shape);
    const double r = std::max(way.norm(), smallest);
    const double phase = wave_number * r;
    const double scale = q.weight * panel.area / (4.0 * pi * r);
    const double half = std::sin(phase / 2.0);
    // exp(-i k r) - 1 and (1 + i k r) exp(-i k r) - 1
    const std::complex<double> green(-2.0 * half * half, -std::sin(phase));
    const std::complex<double> derivative = green + std::complex<double>(0.0, phase) * (green + 1.0);
    const double slope = panel.normal.dot(way) / (r * r);
    for (std::size_t b = 0; b < 3; ++b) {
      potentials.single_layer.at(b) += scale * q.shape[b] * green;
      potentials.double_layer.at(b) += scale * slope * q.shape[b] * derivative;
    }
  }
  return potentials;
}

LayerPotentials layer_potentials(const Panel& panel, const Vector3& point, double wave_number) {
  const double distance = (point - panel.centre).norm() / panel.radius;
  if (distance > 8.0) {
    return quadrature_potentials(panel, point, wave_number, triangle_rule_2());
  }
  return distance > 3.0 ? quadrature_potentials(panel, point, wave_number, triangle_rule_5())
                        : near_potentials(panel, point, wave_number);
}

}  // namespace idiophone::harmonic
