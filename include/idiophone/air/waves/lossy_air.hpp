#pragma once
// What decides how much sound walls take by friction and by conduction of heat.

namespace idiophone::waves {

/// Air with a boundary layer at walls.
struct LossyAir {
  double speed = 343.0;          ///< of sound, m/s
  double viscosity = 1.5e-5;     ///< kinematic, m2/s
  double diffusivity = 2.11e-5;  ///< of heat, m2/s
  double heat_ratio = 1.402;     ///< of the heat capacities at constant pressure and at constant volume
};

/// Keefe 1984, "Acoustical wave propagation in cylindrical ducts", table I.
/// @param speed        of sound, m/s
/// @param density      kg/m3
/// @param temperature  degrees Celsius
[[nodiscard]] constexpr LossyAir lossy_air(double speed, double density, double temperature) {
  const double warmer = temperature - 26.85;                        // than the table's air
  const double viscosity = 1.846e-5 * (1.0 + 0.0025 * warmer);      // Pa s
  const double root_of_prandtl = 0.8410 * (1.0 - 0.0002 * warmer);  // of the Prandtl number
  const double kinematic = viscosity / density;
  return {speed, kinematic, kinematic / (root_of_prandtl * root_of_prandtl), 1.4017 * (1.0 - 0.00002 * warmer)};
}

}  // namespace idiophone::waves
