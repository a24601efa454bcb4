#pragma once
// The blows of a run: where its contacts begin, and where its sound does.

#include <filesystem>
#include <string>
#include <vector>

#include "idiophone/foundation/spectra/listener_sound.hpp"

namespace idiophone::report {

/// One blow, or several within 0.03 s.
struct Impact {
  double time = 0.0;       ///< s, when the bodies touch; or when the sound begins, if no contact of the run explains it
  std::string cause = {};  ///< the names of the contacts, "ball, floor"; empty if only the sound tells
  double force = 0.0;      ///< the largest of the contacts, N; 0 if only the sound tells
  double end = 0.0;        ///< s, when the bodies part; `time` if only the sound tells
};

/// The blows of a result, ascending. A contact makes a new one after 0.02 s without force. A sound that begins up to
/// 0.05 s after a contact belongs to it.
/// @param heard  the sound whose beginnings count besides the contacts
/// @throws std::runtime_error if the result can't be read
[[nodiscard]] std::vector<Impact> impacts(const std::filesystem::path& result, const spectra::Sound& heard);

}  // namespace idiophone::report
