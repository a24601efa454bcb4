#pragma once
// What somebody measured on a real body: resonances, their decay times, and its mass (docs/use/identify.md).

#include <filesystem>
#include <optional>
#include <vector>

namespace idiophone::fitting {

inline constexpr double default_uncertainty = 3.0;  ///< cents

/// A measured resonance, or a line of a spectrum that is taken for one.
struct Line {
  double frequency = 0.0;                    ///< Hz
  double uncertainty = default_uncertainty;  ///< standard deviation, cents
  std::optional<double> decay_time = {};     ///< T60, s
  std::optional<double> level = {};          ///< of a recording, dB
};

struct Measurements {
  std::vector<Line> lines;          ///< at least one, ascending
  std::optional<double> mass = {};  ///< of the body, kg
  std::vector<double> hum = {};     ///< lines of a recording that were left out: of the mains, Hz
};

/// Reads a YAML file (.yaml, .yml) of measurements, or finds the partials in the loudest channel of a sound file, in
/// its best free part (partials::free_parts()). Lines at multiples of 50 or 60 Hz, to 0.3 Hz, that take more than 10 s
/// to decay are hum.
/// @throws deck::DeckError with every mistake of a YAML file; std::runtime_error if the file can't be read or a sound
///         has no partials
[[nodiscard]] Measurements read_measurements(const std::filesystem::path& file);

}  // namespace idiophone::fitting
