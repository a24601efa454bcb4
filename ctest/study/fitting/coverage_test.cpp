// How often the 95 % intervals of constants hold the constants that the bodies were made with, and how often right fits
// are doubted.

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

/// Shares of fits, percent.
struct Shares {
  double young = 0.0;    ///< whose interval of Young's modulus holds the truth
  double poisson = 0.0;  ///< of Poisson's ratio
  double doubted = 0.0;  ///< that are not accepted
};

/// Whether the interval of a constant holds the truth.
bool holds(const IdentifiedConstant& constant, double truth) {
  return std::abs(constant.value - truth) <= constant.half_width;
}

/// Of blocks of random metal, whose twelve lines were read; the deck says aluminium.
Shares shares_of(int bodies) {
  std::mt19937 generator(37);
  std::uniform_real_distribution<double> young(6e10, 8e10), poisson(0.25, 0.38);
  const StrainedBody body = reduced_block();
  int with_young = 0, with_poisson = 0, doubted = 0;
  for (int n = 0; n < bodies; ++n) {
    const scene::Material metal{"metal", young(generator), poisson(generator), 2700, {}, {}};
    const Identification found = identify(body, noisy_lines(body, metal, generator), {});
    with_young += holds(found.constants[0], metal.young) ? 1 : 0;
    with_poisson += holds(found.constants[1], metal.poisson) ? 1 : 0;
    doubted += found.doubts.empty() ? 0 : 1;
  }
  const double percent = 100.0 / bodies;
  const Shares shares{percent * with_young, percent * with_poisson, percent * doubted};
  std::printf(
      "the intervals hold Young's modulus in %.1f %% and Poisson's ratio in %.1f %% of %d bodies; %.1f %% are "
      "doubted\n",
      shares.young, shares.poisson, bodies, shares.doubted);
  return shares;
}

ON_RANKS(1);

// By chance, the share of a hundred is within 4.4 of 95 in 95 of 100 cases.
TEST(Coverage, OfAHundredBodiesIsAboutNinetyFivePercent) {
  const Shares shares = shares_of(100);
  EXPECT_NEAR(shares.young, 95, 5);
  EXPECT_NEAR(shares.poisson, 95, 5);
  EXPECT_LE(shares.doubted, 1.0);
}

TEST(Coverage, OfAThousandBodiesIsNinetyFivePercent) {
  LONG_VERIFICATION();
  const Shares shares = shares_of(1000);
  EXPECT_NEAR(shares.young, 95, 1.0);
  EXPECT_NEAR(shares.poisson, 95, 1.0);
  EXPECT_LE(shares.doubted, 0.4) << "0.1 % are expected, and 0.4 % are more in one of 300 cases";
}

}  // namespace
}  // namespace idiophone::fitting
