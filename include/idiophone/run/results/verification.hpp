#pragma once
// Checks a file: reads everything and compares it with its checksums. The time for reading is limited: if a damaged
// file keeps HDF5 busy for much longer than its size explains, the program ends with a message.

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace idiophone::results {

/// A damaged part of a file.
struct Damage {
  std::string path;             ///< of a dataset or group
  std::string problem;          ///< in words
  std::optional<double> since;  ///< s: earlier rows are intact; none if the part has no times or nothing is intact
};

struct Verification {
  std::vector<Damage> damaged;
  int intact = 0;    ///< datasets that match their checksums
  int unproved = 0;  ///< readable datasets without checksum, as other programs write them
};

/// Reads all of a result, a recording, a checkpoint or a sound map.
/// @throws std::runtime_error if the file can't be opened or is none of them
[[nodiscard]] Verification verify(const std::filesystem::path& path);

/// @throws std::runtime_error that names the damaged parts, if there are any
void require_intact(const std::filesystem::path& path);

/// A table's state at a checkpoint.
struct SavedTable {
  std::int64_t rows = 0;
  std::int64_t digest = 0;  ///< of the checksums of its rows
};

using SavedTables = std::map<std::string, SavedTable>;  ///< by path

/// Compares a file with its state at a checkpoint. Later rows may be damaged.
/// @throws std::runtime_error that names the first difference
void require_as_saved(const std::filesystem::path& path, const SavedTables& tables);

}  // namespace idiophone::results
