#pragma once
// HDF5 lists the pieces of a table in blocks that have rows of before and after a checkpoint side by side. Where such
// a list, or anything else that came after the checkpoint, is damaged, the file can't be continued, though all rows
// that matter can be read: they are copied into a new file.

#include <filesystem>

#include "idiophone/run/results/verification.hpp"

namespace idiophone::results {

/// Replaces a file by a copy of what a checkpoint knows of it: its tables up to the rows of the checkpoint, and all
/// else. By one process, while nobody has the file open.
/// @throws std::runtime_error, and leaves the file as it is, where that can't be read or is damaged
void rebuild_as_saved(const std::filesystem::path& path, const SavedTables& tables);

}  // namespace idiophone::results
