#pragma once
// What bodies radiate at single frequencies, as `idiophone radiate` finds it (docs/use/radiate.md).

#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "idiophone/air/harmonic/boundary_elements.hpp"
#include "idiophone/foundation/types.hpp"

namespace idiophone::harmonic {

/// A motion of one frequency and its sound. Complex numbers belong to exp(+i w t); all are amplitudes.
struct RadiatedSound {
  std::string name;                                     ///< of the motion: "mode 3"
  double frequency = 0.0;                               ///< Hz
  double mean_square_velocity = 0.0;                    ///< of the normal velocity over the body and time, m2/s2
  double power = 0.0;                                   ///< W
  double level_error = NAN;                             ///< estimate of the error of power, dB; NaN: none
  double efficiency = 0.0;                              ///< power/(z area mean_square_velocity)
  double loss_factor = 0.0;                             ///< power/(w energy); NaN where the motion has no energy
  double directivity_index = 0.0;                       ///< loudest direction above the mean over the sphere, dB
  double kirchhoff_error = 0.0;                         ///< power of model kirchhoff above this one, dB
  double kirchhoff_worst = 0.0;                         ///< its error in the worst direction that is no null, dB
  double rayleigh_error = 0.0;                          ///< power of model rayleigh above this one, dB
  double rayleigh_worst = 0.0;                          ///< its error in the worst direction that is no null, dB
  double waves_error = NAN;                             ///< power of model waves above this one, dB; NaN: none
  double waves_worst = NAN;                             ///< its error in the worst direction that is no null, dB
  std::size_t refinements = 0;                          ///< of the surface that it was solved on
  BoundaryField solution;                               ///< on Radiation::surfaces[refinements]
  std::vector<std::complex<double>> listener_pressure;  ///< [listeners] Pa
  std::vector<std::complex<double>> far_field;          ///< [directions] pressure times distance, Pa m
};

/// All sounds of a body, with the surface that radiates and scatters.
struct Radiation {
  std::string body;                          ///< that moves
  std::size_t bodies = 0;                    ///< how many of the parts are bodies; they come first
  std::vector<std::string> parts;            ///< names of bodies and obstacles, in the order of their triangles
  std::vector<std::int32_t> first_triangle;  ///< of each part, and one past the last: [parts + 1]
  std::vector<Boundary> surfaces;            ///< that of the deck, then each refinement: its vertices come first
  std::vector<std::string> listener_names;   ///< of each receiver
  std::vector<Vector3> listener_positions;   ///< m
  std::vector<Vector3> directions;           ///< unit vectors, ring after ring
  std::vector<double> weights;               ///< [directions] sr
  std::int64_t rings = 0;                    ///< of the directions
  double air_density = 0.0;                  ///< kg/m3
  double air_speed = 0.0;                    ///< m/s
  double cell = 0.0;                         ///< of the grid of model waves, m; 0: not computed
  std::vector<RadiatedSound> sounds;

  [[nodiscard]] QuietAir air() const { return {.density = air_density, .speed = air_speed}; }
};

}  // namespace idiophone::harmonic
