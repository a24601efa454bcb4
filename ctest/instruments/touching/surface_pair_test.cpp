#include "surface_pair.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace idiophone::touching {

/// A ball on a flat: 2.87 (m^2/(R E^2 v))^(1/5) (K. L. Johnson, Contact Mechanics, 1985, equation 11.24).
TEST(SurfacePair, AnImpactTakesAsLongAsHertzSays) {
  const Surface steel;
  Surface flat;
  flat.radius = 1e3;
  const double mass = 0.033, speed = 2.0, modulus = 2e11 / (2.0 * (1.0 - 0.09));
  const score::Hammer hammer = impact_of(2.0 * mass * speed, mass, steel, flat);
  EXPECT_DOUBLE_EQ(hammer.speed, speed);
  const double expected = 2.87 * std::pow(mass * mass / (steel.radius * modulus * modulus * speed), 0.2);
  EXPECT_NEAR(hammer.contact_duration(), expected, 1e-3 * expected);
}

}  // namespace idiophone::touching
