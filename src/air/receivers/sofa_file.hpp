#pragma once
// A SOFA file as libmysofa has it.

#include <mysofa.h>

#include <filesystem>

namespace idiophone::receivers {

/// What libmysofa made of a file; null where it failed.
struct SofaFile {
  MYSOFA_EASY* contents = nullptr;  ///< to be closed by mysofa_close()
  int taps = 0;                     ///< of each response
  int error = MYSOFA_OK;            ///< of libmysofa
};

/// Opens a file and resamples its responses to `rate` audio samples a second. Ends the program with a message where a
/// damaged file makes libmysofa crash or never end (files::ReadingLimit).
[[nodiscard]] SofaFile open_sofa_file(const std::filesystem::path& file, int rate);

}  // namespace idiophone::receivers
