#pragma once
// Absorption of sound by the air: ISO 9613-1:1993.

namespace idiophone::radiation {

/// The state of the air, the same everywhere.
struct Atmosphere {
  double temperature = 20.0;   ///< degrees Celsius
  double humidity = 50.0;      ///< relative, per cent
  double pressure = 101325.0;  ///< Pa

  /// Attenuation coefficient alpha of ISO 9613-1, equations 3 to 5 and annex B, as Np/m (1 Np is 8.686 dB): a plane
  /// wave of this frequency (Hz) loses the factor exp(-alpha x) over x metres. The standard claims 10 % for humidities
  /// from 0.05 to 5 % molar, -20 to 50 degrees, less than 200 kPa and 4e-4 to 10 Hz/Pa.
  [[nodiscard]] double attenuation(double frequency) const;
};

}  // namespace idiophone::radiation
