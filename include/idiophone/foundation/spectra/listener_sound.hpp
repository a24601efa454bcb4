#pragma once
// What a listener hears, in memory.

#include <string>
#include <vector>

namespace idiophone::spectra {

/// One listener's channels.
struct Sound {
  std::string name;                          ///< of the listener
  double rate = 0.0;                         ///< samples per second
  std::string unit;                          ///< of the samples, e.g. "Pa m"
  std::vector<std::string> channels;         ///< their names
  std::vector<std::vector<double>> samples;  ///< [channels][samples]
  std::string attached = {};                 ///< the body that carries the listener; empty for none
};

}  // namespace idiophone::spectra
