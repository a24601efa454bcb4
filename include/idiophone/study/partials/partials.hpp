#pragma once
// The partials of a struck sound, modelled as a sum of exponentially damped sines that begin together.

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace idiophone::partials {

/// One damped sine, amplitude e^(-t ln(1000)/decay_time) cos(2 pi frequency t + phase), t from the analysis start.
struct Partial {
  double frequency = 0.0;  ///< Hz
  double level = 0.0;      ///< dB re one unit of the samples: the amplitude at the analysis start
  std::optional<double> decay_time =
      std::nullopt;                  ///< T60, s: the time to fall by 60 dB; none if no decay can be measured
  double frequency_deviation = 0.0;  ///< standard deviation of the frequency, Hz, from the residual of the fit
  double prominence = 0.0;           ///< level of its line above the noise around it, dB
  std::optional<double> remainder =
      std::nullopt;  ///< level of what its line leaves in its width, dB re the line: partials that can't be separated,
                     ///< or a decay that is not exponential; none if that is noise, or outside the dynamic range
};

/// What is analysed, and which lines count as partials.
struct PartialOptions {
  double start = 0.0;                             ///< of the analysis, s; levels are those at this time
  std::optional<double> duration = std::nullopt;  ///< s; up to the end of the sound if omitted
  double lowest = 20.0;                           ///< Hz
  std::optional<double> highest = std::nullopt;   ///< Hz; half the rate if omitted
  double dynamic_range = 80.0;                    ///< dB; fainter lines, relative to the strongest one, are ignored
  double prominence = 15.0;                       ///< least level of a line above the noise around it, dB
  std::optional<double> separation =
      std::nullopt;  ///< least distance of two partials, Hz; 0.5 Hz, or half the inverse of the length if that is less
  std::size_t most = 100;  ///< at most as many partials, the strongest ones
};

/// The partials of a sound.
struct Partials {
  std::vector<Partial> found;  ///< by ascending frequency
  bool complete = true;        ///< false if the search ended early: what is left is no sum of damped sines, but, for
                               ///< example, a click or another blow
};

/// Finds the partials of a sound.
///
/// The search in the spectrum under a falling half-Hann window begins with the strongest line. Each line, together with
/// its neighbours, is fitted by the exact spectrum of damped sines (nonlinear least squares) and subtracted. The search
/// continues in the residual until no line is above the noise.
/// @param samples  [samples] in any unit
/// @param rate     samples per second
/// @throws std::invalid_argument for a sample that is not finite, a rate that is not positive, options out of range, or
///         fewer than 64 samples
[[nodiscard]] Partials find_partials(std::span<const double> samples, double rate, const PartialOptions& options = {});

}  // namespace idiophone::partials
