#include "map_directivity.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "sheet_map.hpp"

namespace idiophone::voices {

using sound_maps::sheet;

TEST(WeightsInDirection, AreExactForSphericalHarmonics) {
  const sound_maps::MapSphere sphere = sheet().sphere;
  const Vector3 direction = Vector3(0.3, -0.5, 0.7).normalized();
  const auto harmonic = [](const Vector3& at) {
    return 1.0 + at.x() * at.y() * at.z() + at.z() * at.z() - 0.4 * at.x();
  };
  const std::vector<double> weights = weights_in_direction(sphere, direction);
  double sum = 0.0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    sum += weights[i] * harmonic(sphere.direction[i]);
  }
  EXPECT_NEAR(sum, harmonic(direction), 1e-12);
}

/// The sheet's modes are 45, and their patterns those of a dipole.
TEST(PressureInDirection, IsThatOfAllModes) {
  const Vector3 direction = Vector3(0.3, -0.5, 0.7).normalized();
  const std::vector<std::complex<double>> pressure = pressure_in_direction(sheet(), direction);
  ASSERT_EQ(pressure.size(), sheet().modes());
  for (std::size_t mode = 0; mode < pressure.size(); ++mode) {
    const double n = static_cast<double>(mode) + 1.0;
    EXPECT_NEAR(std::abs(pressure[mode] - std::complex(n * direction.z(), 0.5 * direction.x())), 0.0, 1e-11) << mode;
  }
}

}  // namespace idiophone::voices
