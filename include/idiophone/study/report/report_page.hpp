#pragma once
// The report of a run: one web page to pass on, with its sounds, spectra, motion and all that was known of the run.

#include <filesystem>
#include <span>
#include <string>

namespace idiophone::report {

/// One HTML page with everything in it.
/// @param results  NAME.h5, one or two; two are compared. Modes are read from NAME_modes.h5 and NAME_BODY_modes.h5
///                 beside a result, if they are of its bodies
/// @throws std::runtime_error if a file can't be read, is damaged or has no sound
[[nodiscard]] std::string page(std::span<const std::filesystem::path> results);

}  // namespace idiophone::report
