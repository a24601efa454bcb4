#pragma once
// The partials that several recordings of one body share: common frequencies and decays, an amplitude in each
// recording.

#include <complex>
#include <vector>

#include "idiophone/study/partials/partials.hpp"

namespace idiophone::partials {

/// In recording k it is Re(amplitude[k] e^((2 pi i frequency - decay) t)), t from the first sample.
struct SharedPartial {
  double frequency = 0.0;                       ///< of the decaying oscillation, Hz
  double decay = 0.0;                           ///< of the amplitude, 1/s, above 0
  std::vector<std::complex<double>> amplitude;  ///< [recordings] in the unit of the samples
};

/// Finds the partials of each recording (find_partials()), joins those of different recordings that can't be told
/// apart, and fits frequencies and decays to all recordings at once (nonlinear least squares). Lines without a
/// measurable decay, such as hum, are left out.
/// @param recordings  [recordings][samples], all of one length, each from a time after its blow on
/// @param options     start and duration are left at their defaults; `most` partials of each recording
/// @return by ascending frequency
/// @throws std::invalid_argument as find_partials(), and for recordings of different lengths
[[nodiscard]] std::vector<SharedPartial> find_shared_partials(const std::vector<std::vector<double>>& recordings,
                                                              double rate, const PartialOptions& options = {});

}  // namespace idiophone::partials
