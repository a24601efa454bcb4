#include "burton_miller.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace idiophone::radiation {

namespace {

using Numbers = std::array<Index, 3>;

/// The system, to which pairs of panels are added.
class Assembly {
 public:
  Assembly(const Boundary& boundary, const std::vector<Panel>& panels, double impedance, double wave_number,
           std::span<const std::vector<Complex>> velocities)
      : boundary_(boundary), panels_(panels), wave_number_(wave_number), coupling_(coupling(panels, wave_number)) {
    const auto vertices = static_cast<Eigen::Index>(boundary.vertices.size());
    system_.matrix.setZero(vertices, vertices);
    system_.right_sides.setZero(vertices, static_cast<Eigen::Index>(velocities.size()));
    slopes_.resize(static_cast<Eigen::Index>(3 * panels.size()), static_cast<Eigen::Index>(velocities.size()));
    for (std::size_t m = 0; m < velocities.size(); ++m) {
      slopes_.col(m) = Complex(0.0, -wave_number * impedance) *
                       Eigen::Map<const Eigen::VectorXcd>(velocities[m].data(), slopes_.rows());
    }
  }

  /// What all panels do to one panel, here or mirrored.
  /// @param outer  panel number t, or its mirror image
  /// @param gain   reflection of the mirror, 1 for the panel itself
  void add_row(std::size_t t, const Panel& outer, double gain) {
    const Numbers& rows = boundary_.triangles[t];
    for (std::size_t s = 0; s < panels_.size(); ++s) {
      const Panel& inner = panels_[s];
      const Numbers& columns = boundary_.triangles[s];
      const PanelPair pair = panel_pair(outer, inner, wave_number_);
      const double facing = wave_number_ * wave_number_ * outer.normal.dot(inner.normal);
      const Complex whole = pair.single_layer.sum();
      for (std::size_t a = 0; a < 3; ++a) {
        const Vector3 curl = outer.normal.cross(outer.gradients.at(a));
        for (std::size_t b = 0; b < 3; ++b) {
          const Complex hypersingular =
              facing * pair.single_layer(a, b) - whole * curl.dot(inner.normal.cross(inner.gradients.at(b)));
          system_.matrix(rows.at(a), columns.at(b)) += gain * (pair.double_layer(a, b) + coupling_ * hypersingular);
          system_.right_sides.row(rows.at(a)) += gain * pair.single_layer(a, b) * slopes_.row(3 * s + b);
          // K' has the double layer's integrals with the panels' parts exchanged.
          system_.right_sides.row(columns.at(b)) += gain * coupling_ * pair.double_layer(a, b) * slopes_.row(3 * t + a);
        }
      }
    }
  }

  /// The parts without integral operators.
  void add_mass(std::size_t t) {
    const Eigen::Matrix3d mass = panel_mass(panels_[t]);
    for (std::size_t a = 0; a < 3; ++a) {
      for (std::size_t b = 0; b < 3; ++b) {
        system_.matrix(boundary_.triangles[t].at(a), boundary_.triangles[t].at(b)) -= 0.5 * mass(a, b);
        system_.right_sides.row(boundary_.triangles[t].at(a)) += 0.5 * coupling_ * mass(a, b) * slopes_.row(3 * t + b);
      }
    }
  }

  /// A point source's pressure and its normal derivative.
  void add_incident(std::size_t t, const PointSource& source) {
    const Panel& panel = panels_[t];
    for (const TrianglePoint& q : triangle_rule_5()) {
      const Vector3 way = panel.at(q.shape) - source.position;
      const double r = way.norm();
      const Complex pressure = source.strength * std::polar(1.0 / r, -wave_number_ * r);
      const Complex slope = -pressure * Complex(1.0 / r, wave_number_) * (way.dot(panel.normal) / r);
      for (std::size_t a = 0; a < 3; ++a) {
        system_.right_sides.row(boundary_.triangles[t].at(a)).array() -=
            q.weight * panel.area * q.shape[a] * (pressure + coupling_ * slope);
      }
    }
  }

  [[nodiscard]] LinearSystem take() { return std::move(system_); }

 private:
  static Complex coupling(const std::vector<Panel>& panels, double wave_number) {
    double area = 0.0;
    for (const Panel& panel : panels) {
      area += panel.area;
    }
    return {0.0, -1.0 / std::max(wave_number, std::sqrt(4.0 * std::numbers::pi / area))};
  }

  const Boundary& boundary_;
  const std::vector<Panel>& panels_;
  double wave_number_;
  Complex coupling_;
  Eigen::MatrixXcd slopes_;  // q = dp/dn, [3 x panels][motions]
  LinearSystem system_;
};

}  // namespace

std::vector<Panel> panels_of(const Boundary& boundary) {
  std::vector<Panel> panels;
  for (const auto& [a, b, c] : boundary.triangles) {
    panels.emplace_back(std::array{boundary.vertices[a], boundary.vertices[b], boundary.vertices[c]});
  }
  return panels;
}

LinearSystem burton_miller(const Boundary& boundary, const std::vector<Panel>& panels, const QuietAir& air,
                           double wave_number, std::span<const std::vector<Complex>> velocities,
                           std::span<const PointSource> sources) {
  Assembly assembly(boundary, panels, air.impedance(), wave_number, velocities);
  for (std::size_t t = 0; t < panels.size(); ++t) {
    assembly.add_mass(t);
    assembly.add_row(t, panels[t], 1.0);
    if (boundary.floor) {
      assembly.add_row(t, mirrored(panels[t], *boundary.floor), boundary.floor->reflection);
    }
    for (const PointSource& source : sources) {
      assembly.add_incident(t, source);
      if (boundary.floor) {
        const ReflectingPlane& floor = *boundary.floor;
        assembly.add_incident(
            t, {floor.at + floor.mirrored(source.position - floor.at), floor.reflection * source.strength});
      }
    }
  }
  return assembly.take();
}

}  // namespace idiophone::radiation
