#include "idiophone/air/propagation/surroundings.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "all_triangles.hpp"
#include "idiophone/foundation/parallel/gather.hpp"
#include "idiophone/solids/mesh/line_crossing.hpp"

namespace idiophone::propagation {

namespace {

/// Signed, as seen from a point: positive where the point is behind the triangle.
double solid_angle(const mesh::TrianglePoints& corners, const Vector3& point) {
  const Vector3 a = corners[0] - point, b = corners[1] - point, c = corners[2] - point;
  const double la = a.norm(), lb = b.norm(), lc = c.norm();
  return 2.0 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
}

bool goes_through(const mesh::TrianglePoints& corners, const Vector3& from, const Vector3& way) {
  const std::optional<double> along = mesh::line_crossing(corners, from, way);
  return along && *along > 0.0 && *along < 1.0;
}

/// Whether a straight way may meet a box: between its two planes along each axis for some time in common.
bool may_meet(const Eigen::AlignedBox3d& box, const Vector3& from, const Vector3& to) {
  double enters = 0.0, leaves = 1.0;  // shares of the way
  for (int axis = 0; axis < 3; ++axis) {
    const double slack = 1e-9 * (std::abs(from[axis]) + std::abs(to[axis]) + box.sizes()[axis]);
    const double low = box.min()[axis] - slack - from[axis], high = box.max()[axis] + slack - from[axis];
    const double way = to[axis] - from[axis];
    if (way == 0.0) {
      leaves = low <= 0.0 && high >= 0.0 ? leaves : -1.0;
      continue;
    }
    enters = std::max(enters, std::min(low / way, high / way));
    leaves = std::min(leaves, std::max(low / way, high / way));
  }
  return enters <= leaves;
}

/// Vertex positions of all ranks, [global vertices] m. Collective.
std::vector<Vector3> all_vertices(const AudibleSurface& surface, MPI_Comm communicator) {
  std::vector<double> coordinates;
  for (const Vector3& vertex : surface.reference) {
    coordinates.insert(coordinates.end(), vertex.begin(), vertex.end());
  }
  const auto numbers = parallel::gather_all(std::span<const Index>(surface.vertex_ids), communicator).values;
  const auto places = parallel::gather_all(std::span<const double>(coordinates), communicator).values;
  std::vector<Vector3> vertices(surface.global_vertices());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    vertices[numbers[i]] = Vector3::Map(&places[3 * i]);
  }
  return vertices;
}

}  // namespace

void Surroundings::add(const std::string& name, std::span<const Vector3> nodes, std::span<const mesh::Triangle> faces) {
  const auto first = static_cast<Index>(vertices.size());
  vertices.insert(vertices.end(), nodes.begin(), nodes.end());
  for (const auto& [a, b, c] : faces) {
    triangles.push_back({first + a, first + b, first + c});
  }
  names.push_back(name);
  first_triangle.push_back(static_cast<Index>(triangles.size()));
}

void Surroundings::add(const std::string& name, std::span<const mesh::TrianglePoints> faces) {
  std::vector<Vector3> nodes;
  std::vector<mesh::Triangle> numbers;
  for (const auto& corners : faces) {
    const auto first = static_cast<Index>(nodes.size());
    nodes.insert(nodes.end(), corners.begin(), corners.end());
    numbers.push_back({first, first + 1, first + 2});
  }
  if (!numbers.empty()) {
    add(name, nodes, numbers);
  }
}

mesh::TrianglePoints Surroundings::corners(Index triangle) const {
  const auto& [a, b, c] = triangles[triangle];
  return {vertices[a], vertices[b], vertices[c]};
}

bool Surroundings::is_inside(std::size_t part, const Vector3& point) const {
  double sum = 0.0;
  for (Index t = first_triangle[part]; t < first_triangle[part + 1]; ++t) {
    sum += solid_angle(corners(t), point);
  }
  return sum > 3.0 * std::numbers::pi;  // 4 pi inside and 0 outside a closed surface
}

Surroundings::Nearest Surroundings::nearest(std::size_t part, const Vector3& point) const {
  Nearest best{.distance = std::numeric_limits<double>::infinity()};
  for (Index t = first_triangle[part]; t < first_triangle[part + 1]; ++t) {
    const mesh::TrianglePoints places = corners(t);
    const double distance = (mesh::at_weights(places, mesh::nearest_weights(places, point)) - point).norm();
    if (distance < best.distance) {
      best = {distance, mesh::longest_edge(places)};
    }
  }
  return best;
}

bool Surroundings::is_between(std::size_t part, const Vector3& from, const Vector3& to) const {
  for (Index t = first_triangle[part]; t < first_triangle[part + 1]; ++t) {
    if (goes_through(corners(t), from, to - from)) {
      return true;
    }
  }
  return false;
}

double Surroundings::share_behind(std::size_t part, std::size_t body, const Vector3& point) const {
  constexpr Index samples = 200;
  Eigen::AlignedBox3d box;
  for (Index t = first_triangle[part]; t < first_triangle[part + 1]; ++t) {
    for (const Vector3& corner : corners(t)) {
      box.extend(corner);
    }
  }
  const Index first = first_triangle[body], last = first_triangle[body + 1];
  double hidden = 0.0, whole = 0.0;
  for (Index t = first; t < last; t += std::max(1, (last - first) / samples)) {
    const auto [a, b, c] = corners(t);
    const Vector3 centre = (a + b + c) / 3.0;
    const double area = (b - a).cross(c - a).norm();
    whole += area;
    hidden += may_meet(box, centre, point) && is_between(part, centre, point) ? area : 0.0;
  }
  return hidden / whole;
}

Surroundings surroundings(const AudibleSurface& surface, MPI_Comm communicator) {
  Surroundings around;
  around.names = surface.bodies;
  around.bodies = surface.bodies.size();
  around.vertices = all_vertices(surface, communicator);
  around.triangles = all_triangles(surface, communicator);
  around.first_triangle = surface.first_triangle;
  around.add("an obstacle", surface.obstacles);
  return around;
}

}  // namespace idiophone::propagation
