#include "idiophone/air/harmonic/boundary_elements.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "burton_miller.hpp"
#include "far_image.hpp"
#include "idiophone/air/harmonic/sphere_rule.hpp"
#include "iterative_solution.hpp"

namespace idiophone::harmonic {

namespace {

constexpr std::size_t most_vertices_of_direct_solver = 2500;

/// @return [vertices x motions]
Eigen::MatrixXcd solve_directly(const Equations& equations, std::span<const PointSource> sources) {
  LinearSystem system = burton_miller(equations, sources);
  const Eigen::PartialPivLU<Eigen::Ref<Eigen::MatrixXcd>> factors(system.matrix);
  Eigen::MatrixXcd pressure = factors.solve(system.right_sides);
  if (!pressure.allFinite()) {
    throw std::runtime_error("boundary elements: the matrix is singular; is the surface closed and without overlaps?");
  }
  return pressure;
}

void check_triangles(const Boundary& boundary) {
  if (boundary.triangles.empty()) {
    throw std::invalid_argument("boundary elements: there are no triangles");
  }
  const auto vertices = static_cast<Index>(boundary.vertices.size());
  std::vector<char> used(boundary.vertices.size());
  for (std::size_t t = 0; t < boundary.triangles.size(); ++t) {
    for (const Index vertex : boundary.triangles[t]) {
      if (vertex < 0 || vertex >= vertices || !boundary.vertices[vertex].allFinite()) {
        throw std::invalid_argument(
            fmt::format("boundary elements: triangle {} has vertex {}, which is not one of the {} finite vertices", t,
                        vertex, vertices));
      }
      used[vertex] = 1;
    }
  }
  if (const auto unused = std::ranges::find(used, 0); unused != used.end()) {
    throw std::invalid_argument(
        fmt::format("boundary elements: vertex {} belongs to no triangle", unused - used.begin()));
  }
}

void check_areas(const std::vector<Panel>& panels) {
  for (std::size_t t = 0; t < panels.size(); ++t) {
    if (!(panels[t].area > 1e-12 * panels[t].radius * panels[t].radius)) {
      throw std::invalid_argument(fmt::format("boundary elements: triangle {} has no area", t));
    }
  }
}

double longest_edge_of(const std::vector<Panel>& panels) {
  double longest = 0.0;
  for (const Panel& panel : panels) {
    for (std::size_t c = 0; c < 3; ++c) {
      longest = std::max(longest, (panel.corners.at((c + 1) % 3) - panel.corners.at(c)).norm());
    }
  }
  return longest;
}

void check_floor(const Boundary& boundary, double longest_edge) {
  for (const Vector3& vertex : boundary.vertices) {
    if (boundary.floor && boundary.floor->normal.dot(vertex - boundary.floor->at) < -1e-3 * longest_edge) {
      throw std::invalid_argument(
          fmt::format("boundary elements: the vertex ({:.4g}, {:.4g}, {:.4g}) is behind the floor", vertex[0],
                      vertex[1], vertex[2]));
    }
  }
}

/// What each panel sends out: p dG/dn - G dp/dn, with dp/dn = -i k z v, at one point or in one direction.
Complex sent_out(const Boundary& boundary, const BoundaryField& field, std::size_t t, double impedance,
                 const LayerPotentials& potentials) {
  const Complex slope(0.0, -field.wave_number * impedance);
  Complex sum = 0.0;
  for (std::size_t b = 0; b < 3; ++b) {
    sum += field.pressure[boundary.triangles[t].at(b)] * potentials.double_layer.at(b) -
           slope * field.normal_velocity[3 * t + b] * potentials.single_layer.at(b);
  }
  return sum;
}

/// Limit of r exp(i k r) times the layer potentials at a distance r in a direction.
LayerPotentials far_potentials(const Panel& panel, const Vector3& direction, double wave_number) {
  LayerPotentials potentials;
  const Complex slope(0.0, wave_number * direction.dot(panel.normal));
  for (const TrianglePoint& q : triangle_rule_5()) {
    const Complex green =
        std::polar(q.weight * panel.area / (4.0 * std::numbers::pi), wave_number * direction.dot(panel.at(q.shape)));
    for (std::size_t b = 0; b < 3; ++b) {
      potentials.single_layer.at(b) += q.shape[b] * green;
      potentials.double_layer.at(b) += q.shape[b] * slope * green;
    }
  }
  return potentials;
}

/// Radius of the bodies and their mirror image about a point of the floor or about their middle, m.
double extent_of(const Boundary& boundary) {
  Vector3 middle = Vector3::Zero();
  for (const Vector3& vertex : boundary.vertices) {
    middle += vertex / static_cast<double>(boundary.vertices.size());
  }
  if (const auto& floor = boundary.floor) {
    middle -= floor->normal.dot(middle - floor->at) * floor->normal;
  }
  double extent = 0.0;
  for (const Vector3& vertex : boundary.vertices) {
    extent = std::max(extent, (vertex - middle).norm());
  }
  return extent;
}

}  // namespace

double solution_time(std::size_t vertices) {
  constexpr double of_a_pair = 5e-6;    // of vertices: the integrals of the matrix, s
  constexpr double of_a_vertex = 6e-3;  // 3e-3 to 12e-3, by the number of iterations
  const auto count = static_cast<double>(vertices);
  return vertices > most_vertices_of_direct_solver ? of_a_vertex * count : of_a_pair * count * count;
}

BoundaryElements::BoundaryElements(Boundary boundary, const QuietAir& air) : boundary_(std::move(boundary)), air_(air) {
  check_triangles(boundary_);
  const std::vector<Panel> panels = panels_of(boundary_);
  check_areas(panels);
  longest_edge_ = longest_edge_of(panels);
  check_floor(boundary_, longest_edge_);
  extent_ = extent_of(boundary_);
}

std::vector<BoundaryField> BoundaryElements::solve(double wave_number, std::span<const std::vector<Complex>> velocities,
                                                   std::span<const PointSource> sources, LinearSolver solver) const {
  if (!(wave_number > 0 && std::isfinite(wave_number))) {
    throw std::invalid_argument(fmt::format("boundary elements: the wave number is {}, not above 0", wave_number));
  }
  const std::vector<Panel> panels = panels_of(boundary_);
  for (const auto& velocity : velocities) {
    if (velocity.size() != 3 * panels.size()) {
      throw std::invalid_argument(fmt::format("boundary elements: {} velocities for {} triangles; there are three each",
                                              velocity.size(), panels.size()));
    }
  }
  const Equations equations(boundary_, panels, air_, wave_number, velocities);
  const bool is_large = boundary_.vertices.size() > most_vertices_of_direct_solver;
  const bool iterates = solver == LinearSolver::iterative || (solver == LinearSolver::by_size && is_large);
  const Eigen::MatrixXcd pressure =
      iterates ? solve_iteratively(equations, sources, longest_edge_) : solve_directly(equations, sources);
  std::vector<BoundaryField> fields;
  for (std::size_t m = 0; m < velocities.size(); ++m) {
    const auto column = pressure.col(static_cast<Eigen::Index>(m));
    BoundaryField& field = fields.emplace_back();
    field.wave_number = wave_number;
    field.pressure.assign(column.begin(), column.end());
    field.normal_velocity = velocities[m];
    field.power = radiated_power(field);
  }
  return fields;
}

std::vector<Complex> BoundaryElements::pressure_at(const BoundaryField& field, std::span<const Vector3> points,
                                                   double attenuation) const {
  const std::vector<Panel> panels = panels_of(boundary_);
  std::vector<Complex> pressures(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto from_all = [&](const Vector3& point) {
      Complex sum = 0.0;
      for (std::size_t t = 0; t < panels.size(); ++t) {
        sum += std::exp(-attenuation * (point - panels[t].centre).norm()) *
               sent_out(boundary_, field, t, air_.impedance(), layer_potentials(panels[t], point, field.wave_number));
      }
      return sum;
    };
    pressures[i] = from_all(points[i]);
    if (const auto& floor = boundary_.floor) {
      pressures[i] += floor->reflection * from_all(floor->at + floor->mirrored(points[i] - floor->at));
    }
  }
  return pressures;
}

std::vector<Complex> BoundaryElements::far_field(const BoundaryField& field,
                                                 std::span<const Vector3> directions) const {
  const std::vector<Panel> panels = panels_of(boundary_);
  std::vector<Complex> pressures;
  const auto from_all = [&](const Vector3& direction) {
    Complex sum = 0.0;
    for (std::size_t t = 0; t < panels.size(); ++t) {
      sum += sent_out(boundary_, field, t, air_.impedance(), far_potentials(panels[t], direction, field.wave_number));
    }
    return sum;
  };
  for (const Vector3& wanted : directions) {
    pressures.push_back(with_image(boundary_.floor, field.wave_number, wanted, from_all));
  }
  return pressures;
}

double BoundaryElements::radiated_power(const BoundaryField& field) const {
  const auto rings = static_cast<unsigned>(std::ceil(field.wave_number * extent_)) + 6;
  const SphereRule sphere = sphere_rule(rings);
  const std::vector<Complex> pressures = far_field(field, sphere.directions);
  double sum = 0.0;
  for (std::size_t d = 0; d < pressures.size(); ++d) {
    sum += sphere.weights[d] * std::norm(pressures[d]);
  }
  return sum / (2.0 * air_.impedance()) * (boundary_.floor ? 0.5 : 1.0);
}

std::vector<Complex> triangle_pressures(const Boundary& boundary, const BoundaryField& field) {
  std::vector<Complex> pressures;
  for (const auto& [a, b, c] : boundary.triangles) {
    pressures.push_back((field.pressure[a] + field.pressure[b] + field.pressure[c]) / 3.0);
  }
  return pressures;
}

}  // namespace idiophone::harmonic
