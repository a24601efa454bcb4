#pragma once
// Blocks of metal whose lines were read with errors.

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <random>

#include "bars.hpp"
#include "strained_body.hpp"

namespace idiophone::fitting {

inline constexpr double read_within = 5.0;  // cents, of a line
inline constexpr int lines_read = 12;

/// A block that can only move by its 40 lowest modes. Of more than that, with the mesh of two cells, the fit would be
/// the same, and the eigenvalue problems would take a hundred times as long.
inline StrainedBody reduced_block() {
  const scene::Scene scene = bar_scene({0.06, 0.025, 0.02}, 0.03, 4);
  return StrainedBody(scene, eigenmodes::MassMatrix::consistent).reduced(40);
}

/// The lowest lines of a body, read with normal errors.
inline Measurements noisy_lines(StrainedBody body, const scene::Material& material, std::mt19937& generator) {
  std::normal_distribution<double> error(0, read_within);
  Measurements measured;
  const Eigen::VectorXd frequencies = body.lowest(material, lines_read).frequencies(material);
  for (const double frequency : frequencies.head(lines_read)) {
    measured.lines.push_back({.frequency = frequency * std::exp2(error(generator) / 1200), .uncertainty = read_within});
  }
  std::ranges::sort(measured.lines, {}, &Line::frequency);
  return measured;
}

}  // namespace idiophone::fitting
