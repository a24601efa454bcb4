#pragma once
// The partials of a struck sound: it is taken for a sum of exponentially damped sines that all begin together.

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace idiophone::analysis {

/// One damped sine, amplitude e^(-t ln(1000)/decay_time) cos(2 pi frequency t + phase), t from the analysis start.
struct Partial {
  double frequency = 0.0;  ///< Hz
  double level = 0.0;      ///< dB re one unit of the samples: the amplitude at the analysis start
  std::optional<double> decay_time =
      std::nullopt;                  ///< T60, s: the time to fall by 60 dB; none where no decay can be told
  double frequency_deviation = 0.0;  ///< standard deviation of the frequency, Hz, from what the fit leaves over
  double prominence = 0.0;           ///< dB by which its line stands above the noise around it
};

/// What to look at and what to take for a partial.
struct PartialOptions {
  double start = 0.0;                             ///< s; begin here, after the blow: levels are those at this time
  std::optional<double> duration = std::nullopt;  ///< s to look at; up to the end of the sound where it is not given
  double lowest = 20.0;                           ///< Hz
  std::optional<double> highest = std::nullopt;   ///< Hz; half the rate where it is not given
  double dynamic_range = 80.0;  ///< dB below the strongest line of the spectrum, nothing fainter is looked for
  double prominence = 15.0;     ///< dB above the noise around it that a line must reach
  double separation = 0.5;      ///< Hz; two partials nearer than this are one
  std::size_t most = 100;       ///< at most so many, the strongest lines
};

/// Finds the partials of a sound.
///
/// The spectrum under a falling half-Hann window is searched from its strongest line downwards. Each line found is
/// fitted, together with those near it, by the exact spectrum of damped sines (nonlinear least squares), and taken
/// out; what is left over is searched again until nothing stands above the noise.
/// @param samples  [samples] in any unit
/// @param rate     samples per second
/// @return by ascending frequency
/// @throws std::invalid_argument for a sample that is not finite, a rate that is not positive, options out of range, or
///         fewer than 64 samples to look at.
[[nodiscard]] std::vector<Partial> find_partials(std::span<const double> samples, double rate,
                                                 const PartialOptions& options = {});

}  // namespace idiophone::analysis
