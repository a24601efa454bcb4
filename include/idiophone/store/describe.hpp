#pragma once
// What `idiophone info` prints.

#include <filesystem>
#include <string>

namespace idiophone::store {

/// Lines of text saying what is in a result, a recording or a checkpoint: versions, tables with shape, unit, rate,
/// duration and loudest value, meshes and frames; for a checkpoint, its step and whether it is valid. Call on one rank,
/// with MPI initialised.
/// @throws std::runtime_error when the file can't be opened or is none of them.
[[nodiscard]] std::string describe(const std::filesystem::path& path);

}  // namespace idiophone::store
