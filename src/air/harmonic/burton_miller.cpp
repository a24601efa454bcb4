#include "burton_miller.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace idiophone::harmonic {

namespace {

Complex coupling_of(const std::vector<Panel>& panels, double wave_number) {
  double area = 0.0;
  for (const Panel& panel : panels) {
    area += panel.area;
  }
  return {0.0, -1.0 / std::max(wave_number, std::sqrt(4.0 * std::numbers::pi / area))};
}

/// What all panels do to one panel, here or mirrored.
/// @param outer  panel number t, or its mirror image
/// @param gain   reflection of the mirror, 1 for the panel itself
void add_rows(const Equations& equations, std::size_t t, const Panel& outer, double gain, LinearSystem& system) {
  const auto& triangles = equations.boundary.triangles;
  const auto& slopes = equations.slopes;
  for (std::size_t s = 0; s < equations.panels.size(); ++s) {
    const Panel& inner = equations.panels[s];
    const PanelPair pair = panel_pair(outer, inner, equations.wave_number);
    const Eigen::Matrix3cd block = equations.pressure_block(outer, inner, pair);
    for (std::size_t a = 0; a < 3; ++a) {
      for (std::size_t b = 0; b < 3; ++b) {
        const Index row = triangles[t].at(a);
        const Index column = triangles[s].at(b);
        system.matrix(row, column) += gain * block(a, b);
        system.right_sides.row(row) += gain * pair.single_layer(a, b) * slopes.row(3 * s + b);
        // K' has the double layer's integrals with the panels' parts exchanged.
        system.right_sides.row(column) += gain * equations.coupling * pair.double_layer(a, b) * slopes.row(3 * t + a);
      }
    }
  }
}

}  // namespace

std::vector<Panel> panels_of(const Boundary& boundary) {
  std::vector<Panel> panels;
  for (const auto& [a, b, c] : boundary.triangles) {
    panels.emplace_back(std::array{boundary.vertices[a], boundary.vertices[b], boundary.vertices[c]});
  }
  return panels;
}

Equations::Equations(const Boundary& boundary_, const std::vector<Panel>& panels_, const QuietAir& air,
                     double wave_number_, std::span<const std::vector<Complex>> velocities)
    : boundary(boundary_),
      panels(panels_),
      wave_number(wave_number_),
      coupling(coupling_of(panels_, wave_number_)),
      slopes(3 * panels_.size(), velocities.size()) {
  for (std::size_t m = 0; m < velocities.size(); ++m) {
    slopes.col(static_cast<Eigen::Index>(m)) = Complex(0.0, -wave_number * air.impedance()) *
                                               Eigen::Map<const Eigen::VectorXcd>(velocities[m].data(), slopes.rows());
  }
}

Eigen::Matrix3cd Equations::pressure_block(const Panel& outer, const Panel& inner, const PanelPair& pair) const {
  const double facing = wave_number * wave_number * outer.normal.dot(inner.normal);
  const Complex whole = pair.single_layer.sum();
  Eigen::Matrix3cd block;
  for (std::size_t a = 0; a < 3; ++a) {
    const Vector3 curl = outer.normal.cross(outer.gradients.at(a));
    for (std::size_t b = 0; b < 3; ++b) {
      const Complex hypersingular =
          facing * pair.single_layer(a, b) - whole * curl.dot(inner.normal.cross(inner.gradients.at(b)));
      block(a, b) = pair.double_layer(a, b) + coupling * hypersingular;
    }
  }
  return block;
}

void Equations::add_incident(std::span<const PointSource> sources, Eigen::MatrixXcd& right_sides) const {
  std::vector<PointSource> all(sources.begin(), sources.end());
  if (const auto& floor = boundary.floor) {
    for (const PointSource& source : sources) {
      all.push_back({floor->at + floor->mirrored(source.position - floor->at), floor->reflection * source.strength});
    }
  }
  for (std::size_t t = 0; t < panels.size(); ++t) {
    for (const TrianglePoint& q : triangle_rule_5()) {
      Complex incident = 0.0;
      for (const PointSource& source : all) {
        const Vector3 way = panels[t].at(q.shape) - source.position;
        const double r = way.norm();
        const Complex pressure = source.strength * std::polar(1.0 / r, -wave_number * r);
        const Complex slope = -pressure * Complex(1.0 / r, wave_number) * (way.dot(panels[t].normal) / r);
        incident += pressure + coupling * slope;
      }
      for (std::size_t a = 0; a < 3; ++a) {
        right_sides.row(boundary.triangles[t].at(a)).array() -= q.weight * panels[t].area * q.shape[a] * incident;
      }
    }
  }
}

LinearSystem burton_miller(const Equations& equations, std::span<const PointSource> sources) {
  LinearSystem system;
  system.matrix.setZero(equations.vertices(), equations.vertices());
  system.right_sides.setZero(equations.vertices(), equations.slopes.cols());
  equations.add_mass(system.matrix, system.right_sides);
  equations.add_incident(sources, system.right_sides);
  for (std::size_t t = 0; t < equations.panels.size(); ++t) {
    add_rows(equations, t, equations.panels[t], 1.0, system);
    if (const auto& floor = equations.boundary.floor) {
      add_rows(equations, t, mirrored(equations.panels[t], *floor), floor->reflection, system);
    }
  }
  return system;
}

}  // namespace idiophone::harmonic
