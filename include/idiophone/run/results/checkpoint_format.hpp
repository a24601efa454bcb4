#pragma once
// Names, checksums and the end marker of checkpoints, for writer and reader.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "idiophone/files/hdf5.hpp"
#include "idiophone/run/results/checkpoint.hpp"

namespace idiophone::results {

/// CRC-32 (zlib) of each dataset's bytes, by its path.
using Checksums = std::map<std::string, std::uint32_t>;

/// "checkpoint_000000000042.h5"
[[nodiscard]] std::string checkpoint_name(std::int64_t step);
/// The step in a name like that; nothing for other names.
[[nodiscard]] std::optional<std::int64_t> step_of(const std::filesystem::path& name);
/// All checkpoints in a directory, newest first.
[[nodiscard]] std::vector<std::filesystem::path> list_checkpoints(const std::filesystem::path& directory);

/// The attribute that is written last: CRC-32 of all that the other checksums do not cover, and of these.
[[nodiscard]] std::uint32_t end_marker(const Identity& identity, const Moment& moment, const Checksums& checksums);

/// Identity and moment as attributes and datasets of a file. Writing is collective.
void write_header(hid_t file, const Identity& identity, const Moment& moment, MPI_Comm communicator);
[[nodiscard]] Identity read_identity(hid_t file);
[[nodiscard]] Moment read_moment(hid_t file);

}  // namespace idiophone::results
