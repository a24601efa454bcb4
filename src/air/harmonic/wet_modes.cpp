#include "idiophone/air/harmonic/wet_modes.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "burton_miller.hpp"
#include "galerkin.hpp"
#include "idiophone/foundation/dense/dense.hpp"

namespace idiophone::harmonic {

namespace {

/// The triangles with the nodes that they have.
Boundary boundary_of(const DryModes& dry) {
  Boundary boundary;
  std::vector<Index> numbers(dry.nodes.size(), -1);
  for (std::array<Index, 3> triangle : dry.triangles) {
    for (Index& node : triangle) {
      Index& number = numbers[node];
      if (number < 0) {
        number = static_cast<Index>(boundary.vertices.size());
        boundary.vertices.push_back(dry.nodes[node]);
      }
      node = number;
    }
    boundary.triangles.push_back(triangle);
  }
  return boundary;
}

/// Outward, at the corners of each triangle, [3 x triangles], for a modal velocity of 1 m sqrt(kg)/s.
template <class Number>
std::vector<Number> normal_velocity(const DryModes& dry, std::size_t mode, const std::vector<Panel>& panels) {
  std::vector<Number> values;
  for (std::size_t t = 0; t < panels.size(); ++t) {
    for (const Index node : dry.triangles[t]) {
      values.push_back(panels[t].normal.dot(Vector3::Map(&dry.shapes[mode][3UL * node])));
    }
  }
  return values;
}

/// Waves with air, by the mass matrix 1 + A of modes and air.
struct CoupledModes {
  Eigen::VectorXd angular;  ///< [modes] rad/s, ascending
  Eigen::MatrixXd shares;   ///< [dry modes x modes]
};

class Coupling {
 public:
  Coupling(const DryModes& dry, std::size_t modes, const QuietAir& air)
      : elements_(boundary_of(dry), air), panels_(panels_of(elements_.boundary())) {
    for (std::size_t m = 0; m < modes; ++m) {
      velocities_.push_back(normal_velocity<Complex>(dry, m, panels_));
    }
    dry_ = 2.0 * std::numbers::pi * Eigen::Map<const Eigen::VectorXd>(dry.frequencies.data(), std::ssize(velocities_));
  }

  [[nodiscard]] const Eigen::VectorXd& dry() const { return dry_; }

  /// Z = R + i w A, [modes x modes] N s/m for unit modal mass.
  [[nodiscard]] Eigen::MatrixXcd impedance(double angular) const {
    const auto fields = elements_.solve(angular / elements_.air().speed, velocities_);
    Eigen::MatrixXcd sums = Eigen::MatrixXcd::Zero(dry_.size(), dry_.size());
    for (std::size_t t = 0; t < panels_.size(); ++t) {
      const Eigen::Matrix3cd mass = panel_mass(panels_[t]).cast<Complex>();
      for (Eigen::Index n = 0; n < sums.cols(); ++n) {
        const auto& [a, b, c] = elements_.boundary().triangles[t];
        const auto& pressure = fields[n].pressure;
        const Eigen::Vector3cd force = mass * Eigen::Vector3cd(pressure[a], pressure[b], pressure[c]);
        for (Eigen::Index m = 0; m < sums.rows(); ++m) {
          sums(m, n) += Eigen::Vector3cd::Map(&velocities_[m][3 * t]).dot(force);
        }
      }
    }
    return 0.5 * (sums + sums.transpose());
  }

  /// w0^2 q = w^2 (1 + A) q.
  [[nodiscard]] CoupledModes modes(const Eigen::MatrixXcd& impedance, double angular) const {
    const Eigen::MatrixXd mass = Eigen::MatrixXd::Identity(dry_.size(), dry_.size()) + impedance.imag() / angular;
    const Eigen::MatrixXd root = dense::inverse_root(mass);
    const auto [values, vectors] = dense::eigenpairs(Eigen::MatrixXd(root * dry_.cwiseAbs2().asDiagonal() * root));
    return {values.cwiseSqrt(), root * vectors};
  }

 private:
  BoundaryElements elements_;
  std::vector<Panel> panels_;
  std::vector<std::vector<Complex>> velocities_;  // [modes] of [3 x triangles], m/s
  Eigen::VectorXd dry_;                           // rad/s
};

WetMode wet_mode(const CoupledModes& coupled, Eigen::Index number, const Eigen::MatrixXcd& impedance,
                 const DryModes& dry) {
  Eigen::VectorXd shares = coupled.shares.col(number);
  shares *= shares[number] < 0.0 ? -1.0 : 1.0;
  WetMode mode;
  mode.frequency = coupled.angular[number] / (2.0 * std::numbers::pi);
  mode.decay = shares.cwiseAbs2().dot(Eigen::Map<const Eigen::VectorXd>(dry.decays.data(), shares.size()));
  mode.radiation_decay = 0.5 * shares.dot(impedance.real() * shares);
  mode.shares.assign(shares.begin(), shares.end());
  return mode;
}

}  // namespace

std::size_t resolved_modes(const DryModes& dry, double speed) {
  double longest = 0.0;
  for (const auto& [a, b, c] : dry.triangles) {
    for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, c}, std::pair{c, a}}) {
      longest = std::max(longest, (dry.nodes[to] - dry.nodes[from]).norm());
    }
  }
  return std::ranges::upper_bound(dry.frequencies, speed / (least_resolution * longest)) - dry.frequencies.begin();
}

std::vector<WetMode> wet_modes(const DryModes& dry, const QuietAir& air, const PartWatch& watch) {
  const std::size_t count = resolved_modes(dry, air.speed);
  std::vector<WetMode> found;
  if (count == 0) {
    return found;
  }
  const Coupling coupling(dry, count, air);
  double angular = coupling.dry()[0];
  Eigen::MatrixXcd impedance = coupling.impedance(angular);
  bool goes_on = true;
  for (Eigen::Index n = 0; goes_on && n < coupling.dry().size(); ++n) {
    angular = coupling.modes(impedance, angular).angular[n];
    impedance = coupling.impedance(angular);
    found.push_back(wet_mode(coupling.modes(impedance, angular), n, impedance, dry));
    goes_on = !watch || watch(found.size(), count);
  }
  return found;
}

double estimated_shift(const DryModes& dry, std::size_t mode, const QuietAir& air) {
  const std::vector<Panel> panels = panels_of({dry.nodes, dry.triangles});
  const std::vector<double> values = normal_velocity<double>(dry, mode, panels);
  double area = 0.0, square = 0.0, slope = 0.0;
  for (std::size_t t = 0; t < panels.size(); ++t) {
    const Vector3 corners = Vector3::Map(&values[3 * t]);
    Vector3 gradient = Vector3::Zero();
    for (std::size_t c = 0; c < 3; ++c) {
      gradient += corners[static_cast<Eigen::Index>(c)] * panels[t].gradients.at(c);
    }
    area += panels[t].area;
    square += corners.dot(panel_mass(panels[t]) * corners);
    slope += panels[t].area * gradient.squaredNorm();
  }
  if (!(square > 0.0)) {
    return 0.0;
  }
  const double wave_number = 2.0 * std::numbers::pi * dry.frequencies[mode] / air.speed;
  const double depth = 1.0 / std::sqrt(slope / square + wave_number * wave_number + 4.0 * std::numbers::pi / area);
  return 600.0 * std::log2(1.0 + air.density * square * depth);
}

std::pair<std::size_t, double> largest_estimated_shift(const DryModes& dry, const QuietAir& air) {
  std::pair<std::size_t, double> largest;
  for (std::size_t mode = 0; mode < dry.shapes.size(); ++mode) {
    if (const double shift = estimated_shift(dry, mode, air); shift > largest.second) {
      largest = {mode, shift};
    }
  }
  return largest;
}

double cents(double from, double to) {
  return 1200.0 * std::log2(to / from);
}

}  // namespace idiophone::harmonic
