#pragma once
// Whether a file is what was written: everything is read and compared with its checksums. Reading is bounded: a file
// that keeps HDF5 busy for much longer than its size explains ends the program with a message.

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace idiophone::store {

/// A part of a file that is not what was written.
struct Damage {
  std::string path;             ///< of a dataset or group
  std::string problem;          ///< in words
  std::optional<double> since;  ///< s: what is before is intact; none where the part has no times or nothing is intact
};

struct Verification {
  std::vector<Damage> damaged;
  int intact = 0;    ///< datasets that have their checksums
  int unproved = 0;  ///< datasets that can be read, but have no checksum: another program's
};

/// Reads all of a result, a recording or a checkpoint.
/// @throws std::runtime_error when the file can't be opened or is none of them
[[nodiscard]] Verification verify(const std::filesystem::path& path);

/// @throws std::runtime_error naming what is damaged, when anything is
void require_intact(const std::filesystem::path& path);

/// What a checkpoint knows of a table.
struct SavedTable {
  std::int64_t rows = 0;
  std::int64_t digest = 0;  ///< of the checksums of its rows
};

using SavedTables = std::map<std::string, SavedTable>;  ///< by path

/// Compares a file with what it was at a checkpoint. Rows that came later may be damaged.
/// @throws std::runtime_error naming the first difference
void require_as_saved(const std::filesystem::path& path, const SavedTables& tables);

}  // namespace idiophone::store
