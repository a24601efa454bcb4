#include "directors.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "checks.hpp"
#include "idiophone/foundation/element/lagrange.hpp"

namespace idiophone::mesh {

namespace {

constexpr double smallest_projection = 0.3;  ///< of a quadrilateral's normal on the mean one: edges above 35 degrees

/// A quadrilateral at one of its nodes.
struct Incidence {
  Index quadrilateral;
  Index node;
  Vector3 normal;  ///< of length 1
  double angle;    ///< of the quadrilateral around the node, rad
};

/// Angle of a quadrilateral around a node of its outline or within.
double angle_at(Index i, Index j, Index order, const std::array<Vector3, 2>& tangents) {
  const bool at_end_of_first = i == 0 || i == order;
  const bool at_end_of_second = j == 0 || j == order;
  if (!at_end_of_first || !at_end_of_second) {
    return at_end_of_first || at_end_of_second ? std::numbers::pi : 2 * std::numbers::pi;
  }
  const Vector3 first = i == 0 ? tangents[0] : Vector3(-tangents[0]);
  const Vector3 second = j == 0 ? tangents[1] : Vector3(-tangents[1]);
  return std::atan2(first.cross(second).norm(), first.dot(second));
}

std::vector<Incidence> incidences(const scene::Body& body, const SurfaceMesh& surface) {
  const QuadrilateralGradient gradient(surface.order);
  std::vector<Incidence> result;
  std::vector<std::string> flat;
  for (Index number = 0; number < std::ssize(surface.element_tags); ++number) {
    const auto nodes = surface.quadrilateral(number);
    bool is_flat = false;
    for (Index at = 0; at < std::ssize(nodes); ++at) {
      const auto tangents = gradient(nodes, at, surface.nodes);
      const Vector3 normal = tangents[0].cross(tangents[1]);
      is_flat |= !(normal.norm() > 1e-6 * (tangents[0].squaredNorm() + tangents[1].squaredNorm()));
      result.push_back({number, nodes[at], normal.normalized(),
                        angle_at(at % (surface.order + 1), at / (surface.order + 1), surface.order, tangents)});
    }
    if (is_flat) {
      flat.push_back(quadrilateral_text(surface, number));
    }
  }
  if (!flat.empty()) {
    refuse_culprits(body, fmt::format("has {} quadrilaterals without area at a node:", flat.size()), flat);
  }
  return result;
}

}  // namespace

QuadrilateralGradient::QuadrilateralGradient(int order) : width_(order + 1), slopes_(width_, width_) {
  const Eigen::VectorXd nodes = element::evenly_spaced_nodes(order);
  for (Index at = 0; at < width_; ++at) {
    slopes_.row(at) = element::lagrange(nodes, nodes[at]).slopes;
  }
}

std::array<Vector3, 2> QuadrilateralGradient::operator()(std::span<const Index> nodes, Index at,
                                                         const std::vector<Vector3>& field) const {
  const Index i = at % width_;
  const Index j = at / width_;
  std::array<Vector3, 2> result = {Vector3::Zero(), Vector3::Zero()};
  for (Index a = 0; a < width_; ++a) {
    result[0] += slopes_(i, a) * field[nodes[a + width_ * j]];
    result[1] += slopes_(j, a) * field[nodes[i + width_ * a]];
  }
  return result;
}

std::vector<Vector3> directors_of(const scene::Body& body, const SurfaceMesh& surface) {
  const std::vector<Incidence> all = incidences(body, surface);
  std::vector<Vector3> normals(surface.nodes.size(), Vector3::Zero());
  std::vector<double> angles(surface.nodes.size(), 0.0);
  for (const Incidence& one : all) {
    normals[one.node] += one.angle * one.normal;
    angles[one.node] += one.angle;
  }
  for (Vector3& normal : normals) {
    normal.normalize();
  }
  std::vector<double> projections(surface.nodes.size(), 0.0);
  std::vector<std::string> sharp;
  for (const Incidence& one : all) {
    const double projection = one.normal.dot(normals[one.node]);
    projections[one.node] += one.angle / angles[one.node] * projection;
    if (!(projection >= smallest_projection)) {
      sharp.push_back(quadrilateral_text(surface, one.quadrilateral));
    }
  }
  if (!sharp.empty()) {
    sharp.erase(std::unique(sharp.begin(), sharp.end()), sharp.end());
    refuse_culprits(body,
                    "has quadrilaterals that meet their neighbours at less than 35 degrees, or are folded:", sharp);
  }
  for (std::size_t node = 0; node < normals.size(); ++node) {
    if (angles[node] > 0.0) {
      normals[node] /= projections[node];
    }
  }
  return normals;
}

}  // namespace idiophone::mesh
