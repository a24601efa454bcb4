// How often the 95 % intervals of constants hold the constants that the bodies were made with.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

#include "bars.hpp"
#include "idiophone/study/fitting/identification.hpp"
#include "long_verification.hpp"
#include "ranks.hpp"
#include "strained_body.hpp"

namespace idiophone::fitting {
namespace {

ON_RANKS(1);

// A thousand blocks of random metal, whose twelve lines were read with normal errors of 5 cents.
TEST(Coverage, OfAThousandBodiesIsNinetyFivePercent) {
  LONG_VERIFICATION();
  constexpr int bodies = 1000;
  constexpr double uncertainty = 5.0;  // cents; the mesh errs by much less
  std::mt19937 generator(37);
  std::normal_distribution<double> error(0, uncertainty);
  std::uniform_real_distribution<double> young(6e10, 8e10), poisson(0.25, 0.38);
  scene::Scene block = bar_scene({0.06, 0.025, 0.02}, 0.03, 5);
  StrainedBody body(block, eigenmodes::MassMatrix::consistent);
  int young_inside = 0, poisson_inside = 0;
  for (int n = 0; n < bodies; ++n) {
    const scene::Material metal{"metal", young(generator), poisson(generator), 2700, {}, {}};
    const FrequencyModel model = body.lowest(metal, 12);
    Measurements measured;
    for (const double frequency : model.frequencies(metal)) {
      measured.lines.push_back(
          {.frequency = frequency * std::exp2(error(generator) / 1200), .uncertainty = uncertainty});
    }
    std::ranges::sort(measured.lines, {}, &Line::frequency);
    const Identification found = identify(block, measured, {});
    young_inside += std::abs(found.constants[0].value - metal.young) <= found.constants[0].half_width ? 1 : 0;
    poisson_inside += std::abs(found.constants[1].value - metal.poisson) <= found.constants[1].half_width ? 1 : 0;
  }
  std::printf("the intervals hold Young's modulus in %.1f %% and Poisson's ratio in %.1f %% of %d bodies\n",
              100.0 * young_inside / bodies, 100.0 * poisson_inside / bodies, bodies);
  EXPECT_NEAR(100.0 * young_inside / bodies, 95, 1.0);
  EXPECT_NEAR(100.0 * poisson_inside / bodies, 95, 1.0);
}

}  // namespace
}  // namespace idiophone::fitting
