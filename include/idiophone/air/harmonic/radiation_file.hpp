#pragma once
// NAME_radiation.h5: what `idiophone radiate` finds (docs/use/radiate.md), and NAME_radiation.xdmf, which shows it in
// ParaView.

#include <filesystem>

#include "idiophone/air/harmonic/body_radiation.hpp"
#include "idiophone/foundation/origin.hpp"

namespace idiophone::harmonic {

/// Writes both files; those that are there are replaced at once or not at all. Call on one rank.
/// @throws std::runtime_error if the disk does not take them
void write_radiation(const std::filesystem::path& path, const Origin& origin, const Radiation& radiation);

/// What a file has.
struct StoredRadiation {
  Origin origin;
  Radiation radiation;
};

/// Reads NAME_radiation.h5 with its solutions.
/// @throws std::runtime_error when the file can't be opened, is none of this format, has no solutions, as files of
///         older versions, or contradicts itself
[[nodiscard]] StoredRadiation read_radiation(const std::filesystem::path& path);

}  // namespace idiophone::harmonic
