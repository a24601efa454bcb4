#pragma once
// Sound levels as sound level meters state them.

#include <span>
#include <vector>

namespace idiophone::levels {

/// One third of an octave.
struct ThirdOctave {
  double nominal = 0.0;  ///< the rounded middle frequency that names it, Hz
  double level = 0.0;    ///< equivalent continuous level of the sound in it, dB
};

/// Levels of one channel, dB re the reference. `spectra::silence` for what is silent.
struct Levels {
  double equivalent = 0.0;  ///< Leq: of the root mean square over the whole time
  double weighted = 0.0;    ///< LAeq: the same under the frequency weighting A (IEC 61672-1)
  double exposure = 0.0;    ///< LAE: the level of a second that has the A-weighted energy of the whole sound
  double peak = 0.0;        ///< of the sample of largest magnitude, without weighting
  std::vector<ThirdOctave> bands = {};  ///< from 20 Hz on, as far as they lie below half the rate
};

/// What is before a sound: silence, or more of it, because it is a part of a longer one.
enum class Beginning { silence, inside };

/// The levels of a sound. The energy in each band is the exact sum of the energy spectrum between its edges (ideal
/// filters), and the bands are those of IEC 61260-1 to the base ten: the middle of band x is at 1000 Hz 10^(x/10), its
/// edges are 10^(1/20) below and above. A sound that is cut off at its end has no click there.
/// @param samples    [samples], at least one
/// @param rate       samples per second
/// @param reference  in the unit of the samples: 20e-6 for Pa
/// @throws std::invalid_argument for no sample, a sample that is not finite, or a rate or reference that is not
/// positive
[[nodiscard]] Levels levels_of(std::span<const double> samples, double rate, double reference,
                               Beginning beginning = Beginning::silence);

}  // namespace idiophone::levels
