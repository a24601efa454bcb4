#pragma once
// A free bar of wood as a beam of Timoshenko: cheap, so that many can be tuned in a test.

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "idiophone/study/bench/cut_model.hpp"

namespace idiophone::bench {

struct Beam {
  double young = 13.5e9, shear = 1.5e9;  // Pa
  double density = 850.0;                // kg/m3
  double thicker = 0.0;                  // m, than the arch
  double relief = 1.0;                   // what a cut does, over what the beam's own slopes say

  static constexpr double length = 0.34, width = 0.04;  // m
  static constexpr int elements = 85;                   // of 4 mm, each with the mean thickness there
  static constexpr double step = length / elements;
  static constexpr int strips = 8;  // in an element
  static constexpr int partials = 3;

  /// The vertical bending modes of the beam with some cuts. [partials] cents, and cents/m for each element
  [[nodiscard]] CutBody with(const std::vector<Cut>& cuts) const;

  /// Thickness of an element, m
  [[nodiscard]] double thickness(int element, const std::vector<Cut>& cuts) const {
    double sum = 0.0;
    for (int strip = 0; strip < strips; ++strip) {
      const double x = (element + (strip + 0.5) / strips) * step - length / 2;
      sum += 0.0077 + (0.022 - 0.0077) * std::pow(std::min(1.0, std::abs(x) / 0.0942), 3.39) + thicker;
      for (const Cut& cut : cuts) {
        sum -= relief * cut.depth * depth_share(cut.tool, x - cut.place);
      }
    }
    return sum / strips;
  }
};

namespace beam_parts {

using Matrix4 = Eigen::Matrix4d;

/// Stiffness for a deflection and a rotation at either end, with the shear coefficient 5/6 (Przemieniecki 1968).
inline Matrix4 stiffness(const Beam& beam, double h) {
  const double l = Beam::step, bending = beam.young * Beam::width * h * h * h / 12;
  const double shear = 5.0 / 6 * beam.shear * Beam::width * h, phi = 12 * bending / (shear * l * l);
  Matrix4 k;
  k << 12, 6 * l, -12, 6 * l, 6 * l, (4 + phi) * l * l, -6 * l, (2 - phi) * l * l, -12, -6 * l, 12, -6 * l, 6 * l,
      (2 - phi) * l * l, -6 * l, (4 + phi) * l * l;
  return bending / ((1 + phi) * l * l * l) * k;
}

/// Half of the mass at either end, with its rotation.
inline Matrix4 mass(const Beam& beam, double h) {
  const double m = beam.density * Beam::width * h * Beam::step / 2;
  return Eigen::Vector4d(m, m * h * h / 12, m, m * h * h / 12).asDiagonal();
}

}  // namespace beam_parts

inline CutBody Beam::with(const std::vector<Cut>& cuts) const {
  constexpr int size = 2 * (elements + 1);
  Eigen::MatrixXd k = Eigen::MatrixXd::Zero(size, size);
  Eigen::VectorXd m = Eigen::VectorXd::Zero(size);
  std::vector<double> thick;
  for (int e = 0; e < elements; ++e) {
    thick.push_back(thickness(e, cuts));
    k.block<4, 4>(2 * e, 2 * e) += beam_parts::stiffness(*this, thick.back());
    m.segment<4>(2 * e) += beam_parts::mass(*this, thick.back()).diagonal();
  }
  const Eigen::VectorXd root = m.cwiseSqrt().cwiseInverse();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(root.asDiagonal() * k * root.asDiagonal());
  CutBody body{Eigen::VectorXd(partials), {}};
  body.strips = {step / strips, 0.022, {}, Eigen::MatrixXd(partials, strips * elements)};
  const double in_cents = 600 / std::numbers::ln2;  // of a change of ln(w^2)
  for (int mode = 0; mode < partials; ++mode) {
    const double square = solver.eigenvalues()[mode + 2];
    const Eigen::VectorXd shape = root.cwiseProduct(solver.eigenvectors().col(mode + 2));
    body.moved[mode] = in_cents * std::log(square);
    for (int e = 0; e < elements; ++e) {
      constexpr double less = 1e-6;  // m
      const auto matrix = [&](double h) {
        return Eigen::Matrix4d(beam_parts::stiffness(*this, h) - square * beam_parts::mass(*this, h));
      };
      const Eigen::Vector4d part = shape.segment<4>(2 * e);
      body.strips.slopes.row(mode)
          .segment<strips>(strips * e)
          .setConstant(in_cents * part.dot((matrix(thick[e] - less) - matrix(thick[e] + less)) * part) /
                       (2 * less * square * strips));
    }
  }
  for (int strip = 0; strip < strips * elements; ++strip) {
    body.strips.places.push_back((strip + 0.5) * step / strips - length / 2);
  }
  return body;
}

}  // namespace idiophone::bench
