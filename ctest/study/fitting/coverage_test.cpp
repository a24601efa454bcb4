// How often the 95 % intervals of constants hold the constants that the bodies were made with.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

#include "bars.hpp"
#include "long_verification.hpp"
#include "material_fit.hpp"
#include "ranks.hpp"

namespace idiophone::fitting {
namespace {

constexpr double read_within = 5.0;  // cents, of a line
constexpr int lines_read = 12;

/// A block that can only move by its 40 lowest modes. Of more than that, with the mesh of two cells, the fit would be
/// the same, and the eigenvalue problems would take a hundred times as long.
StrainedBody reduced_block() {
  const scene::Scene scene = bar_scene({0.06, 0.025, 0.02}, 0.03, 4);
  return StrainedBody(scene, eigenmodes::MassMatrix::consistent).reduced(40);
}

/// The lowest lines of a body, read with normal errors.
Measurements noisy_lines(StrainedBody body, const scene::Material& material, std::mt19937& generator) {
  std::normal_distribution<double> error(0, read_within);
  Measurements measured;
  const Eigen::VectorXd frequencies = body.lowest(material, lines_read).frequencies(material);
  for (const double frequency : frequencies.head(lines_read)) {
    measured.lines.push_back({.frequency = frequency * std::exp2(error(generator) / 1200), .uncertainty = read_within});
  }
  std::ranges::sort(measured.lines, {}, &Line::frequency);
  return measured;
}

/// Shares of the intervals of Young's modulus and Poisson's ratio that hold the truth, in percent. Blocks of random
/// metal, whose twelve lines were read; the deck says aluminium.
Eigen::Vector2d coverage_of(int bodies) {
  std::mt19937 generator(37);
  std::uniform_real_distribution<double> young(6e10, 8e10), poisson(0.25, 0.38);
  const StrainedBody body = reduced_block();
  Eigen::Vector2d inside = Eigen::Vector2d::Zero();
  for (int n = 0; n < bodies; ++n) {
    const scene::Material metal{"metal", young(generator), poisson(generator), 2700, {}, {}};
    const Identification found = identify(body, noisy_lines(body, metal, generator), {});
    const Eigen::Vector2d truth(metal.young, metal.poisson);
    for (std::size_t k = 0; k < 2; ++k) {
      const IdentifiedConstant& constant = found.constants[k];
      inside[static_cast<Eigen::Index>(k)] +=
          std::abs(constant.value - truth[static_cast<Eigen::Index>(k)]) <= constant.half_width;
    }
  }
  std::printf("the intervals hold Young's modulus in %.1f %% and Poisson's ratio in %.1f %% of %d bodies\n",
              100 * inside[0] / bodies, 100 * inside[1] / bodies, bodies);
  return 100 * inside / bodies;
}

ON_RANKS(1);

// By chance, the share of a hundred is within 4.4 of 95 in 95 of 100 cases.
TEST(Coverage, OfAHundredBodiesIsAboutNinetyFivePercent) {
  const Eigen::Vector2d inside = coverage_of(100);
  EXPECT_NEAR(inside[0], 95, 5);
  EXPECT_NEAR(inside[1], 95, 5);
}

TEST(Coverage, OfAThousandBodiesIsNinetyFivePercent) {
  LONG_VERIFICATION();
  const Eigen::Vector2d inside = coverage_of(1000);
  EXPECT_NEAR(inside[0], 95, 1.0);
  EXPECT_NEAR(inside[1], 95, 1.0);
}

}  // namespace
}  // namespace idiophone::fitting
