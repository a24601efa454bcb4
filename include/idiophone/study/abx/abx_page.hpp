#pragma once
// A blind listening test of two sounds, as a web page.

#include <filesystem>
#include <string>

namespace idiophone::abx {

struct Settings {
  std::filesystem::path a, b;  ///< results, NAME.h5, or sound files: WAV, FLAC, ...
  std::string listener;        ///< of results; empty where they have only one
  bool match_levels = false;   ///< both sounds get the same energy
  int trials = 16;             ///< how often the listener answers
};

/// One HTML page with both sounds in it. It plays A, B and X, which is A or B by chance in each trial, counts right
/// answers and tells how probable so many are by guessing. The louder sound gets a peak of 0.9; both keep the ratio of
/// their levels unless these are matched.
/// @throws std::runtime_error where a sound can't be read, is silent or has more than two channels; where there are
///         several listeners and none is chosen; where the two have different units and their levels are not matched
[[nodiscard]] std::string page(const Settings& settings);

}  // namespace idiophone::abx
