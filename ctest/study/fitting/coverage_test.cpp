// How often the 95 % intervals of constants hold the constants that the bodies were made with, and how often right fits
// are doubted.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <random>

#include "long_verification.hpp"
#include "material_fit.hpp"
#include "noisy_blocks.hpp"
#include "ranks.hpp"

namespace idiophone::fitting {
namespace {

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
