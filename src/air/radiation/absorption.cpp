#include "idiophone/air/radiation/absorption.hpp"

#include <cmath>

namespace idiophone::radiation {

double Atmosphere::attenuation(double frequency) const {
  const double kelvin = temperature + 273.15;
  const double warmth = kelvin / 293.15;                                                         // T/T_0
  const double compression = pressure / 101325.0;                                                // p_a/p_r
  const double saturation = std::pow(10.0, 4.6151 - 6.8346 * std::pow(273.16 / kelvin, 1.261));  // p_sat/p_r
  const double vapour = humidity * saturation / compression;  // molar concentration h, per cent
  // Relaxation frequencies of oxygen and nitrogen, Hz: equations 3 and 4.
  const double oxygen = compression * (24.0 + 4.04e4 * vapour * (0.02 + vapour) / (0.391 + vapour));
  const double nitrogen = compression / std::sqrt(warmth) *
                          (9.0 + 280.0 * vapour * std::exp(-4.170 * (std::pow(warmth, -1.0 / 3.0) - 1.0)));
  // Equation 5, without the 8.686 dB of a neper.
  const double square = frequency * frequency;
  const double classical = 1.84e-11 / compression * std::sqrt(warmth);
  const double relaxation = 0.01275 * std::exp(-2239.1 / kelvin) / (oxygen + square / oxygen) +
                            0.1068 * std::exp(-3352.0 / kelvin) / (nitrogen + square / nitrogen);
  return square * (classical + std::pow(warmth, -2.5) * relaxation);
}

}  // namespace idiophone::radiation
