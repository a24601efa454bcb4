#pragma once
// What `idiophone info` prints.

#include <filesystem>
#include <string>

namespace idiophone::contents {

/// Lines of text saying what is in a result, a recording, a checkpoint or a sound map: versions, tables with shape,
/// unit, rate, duration and loudest value, meshes and frames; for a checkpoint, its step and whether it is valid. Call
/// on one rank, with MPI initialised.
/// @throws std::runtime_error if the file can't be opened or is none of them.
[[nodiscard]] std::string describe(const std::filesystem::path& path);

/// The same and all attributes as JSON: those of the file, `run` (docs/use/result_file.md, /run), and by their paths
/// `datasets`, each with `shape`, its attributes, the `text` of texts and the `loudest` value of series.
/// @throws std::runtime_error as describe() does.
[[nodiscard]] std::string describe_as_json(const std::filesystem::path& path);

}  // namespace idiophone::contents
