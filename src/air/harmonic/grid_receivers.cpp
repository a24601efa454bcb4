#include "grid_receivers.hpp"

#include <cmath>

#include "idiophone/foundation/each_once.hpp"

namespace idiophone::harmonic {

namespace {

/// Distance of near vertices in nodes of the grid: beyond, polynomials represent a kernel of 1/r^3 to about 0.1 %.
constexpr double near_nodes = 6.0;

/// [vertices] the triangles that touch each.
std::vector<std::vector<Index>> triangles_at(const Boundary& boundary) {
  std::vector<std::vector<Index>> all(boundary.vertices.size());
  for (std::size_t t = 0; t < boundary.triangles.size(); ++t) {
    for (const Index vertex : boundary.triangles[t]) {
      all[vertex].push_back(static_cast<Index>(t));
    }
  }
  return all;
}

void find_neighbours(const Equations& equations, const Grid& grid, Receiver& receiver) {
  const auto& vertices = equations.boundary.vertices;
  const auto triangles = triangles_at(equations.boundary);
  const double square = std::pow(near_nodes * grid.spacing, 2);
  for (const Vector3& place : receiver.places) {
    auto& near = receiver.vertices.emplace_back();
    auto& panels = receiver.panels_near.emplace_back();
    for (std::size_t b = 0; b < vertices.size(); ++b) {
      if ((vertices[b] - place).squaredNorm() < square) {
        near.push_back(static_cast<Index>(b));
        panels.insert(panels.end(), triangles[b].begin(), triangles[b].end());
      }
    }
    keep_each_once(panels);
  }
}

void find_tests(const Equations& equations, const Grid& grid, Receiver& receiver) {
  for (const Vector3& place : receiver.places) {
    receiver.tests.push_back({grid.nearest(place), Eigen::VectorXcd::Zero(grid.stencil_size())});
  }
  for (std::size_t t = 0; t < receiver.panels.size(); ++t) {
    const Panel& panel = receiver.panels[t];
    for (std::size_t a = 0; a < 3; ++a) {
      Stencil& test = receiver.tests[equations.boundary.triangles[t].at(a)];
      for (const TrianglePoint& q : triangle_rule_5()) {
        const Interpolation at = interpolate(grid, test.middle, panel.at(q.shape), panel.normal);
        test.weights += q.weight * panel.area * q.shape[a] * (at.value + equations.coupling * at.slope);
      }
    }
  }
}

}  // namespace

std::vector<Vector3> vertices_and_images(const Boundary& boundary) {
  std::vector<Vector3> points = boundary.vertices;
  if (const auto& floor = boundary.floor) {
    for (const Vector3& vertex : boundary.vertices) {
      points.emplace_back(floor->at + floor->mirrored(vertex - floor->at));
    }
  }
  return points;
}

std::vector<Receiver> receivers_of(const Equations& equations, const Grid& grid) {
  std::vector<Receiver> receivers;
  const Boundary& boundary = equations.boundary;
  Receiver& direct = receivers.emplace_back();
  direct.panels = equations.panels;
  direct.places = boundary.vertices;
  if (const auto& floor = boundary.floor) {
    Receiver& image = receivers.emplace_back();
    image.gain = floor->reflection;
    for (const Panel& panel : equations.panels) {
      image.panels.push_back(mirrored(panel, *floor));
    }
    const std::vector<Vector3> points = vertices_and_images(boundary);
    image.places.assign(points.begin() + std::ssize(boundary.vertices), points.end());
  }
  for (Receiver& receiver : receivers) {
    find_neighbours(equations, grid, receiver);
    find_tests(equations, grid, receiver);
  }
  return receivers;
}

}  // namespace idiophone::harmonic
