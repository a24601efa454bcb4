#pragma once
// Checksums of a table that grows: one for each full piece of a fixed number of rows, in a dataset of /checksums that
// the first full piece creates, and one for the rows after the last full piece, an attribute of the table. Appending
// rows never changes the checksum of a full piece, so a run that is killed leaves a file whose checksums are right.

#include <cstdint>
#include <string>
#include <vector>

#include "idiophone/files/hdf5_dataset.hpp"

namespace idiophone::files {

/// Bytes that a new chunk of checksums takes.
inline constexpr hsize_t room_for_checksums = 2048;

/// Path of the group that has the checksums of full pieces.
inline const std::string checksums_group = "/checksums";

/// A dataset without rows, [0 x row...], that can grow, and its checksums. Its chunks are the pieces. Collective.
[[nodiscard]] hdf5::Identifier create_checked_table(hid_t file, const std::string& path, hid_t type,
                                                    const hdf5::Dimensions& row, hsize_t piece_rows);

/// The dataset of the checksums of a table's full pieces, [full pieces]. Collective if it is created.
/// @param path  of the table
[[nodiscard]] hdf5::Identifier open_or_create_checksums(hid_t file, const std::string& path);

/// Keeps the checksums of the first pieces only, or removes their dataset if there are none. Collective.
/// @param path  of the table
void cut_checksums(hid_t file, const std::string& path, hsize_t full_pieces);

/// Rows in a piece; 0 if the table has no checksums, as in files of other programs.
[[nodiscard]] std::int64_t piece_rows_of(hid_t table);

/// Checksum of the values in a box, as they are stored. @throws std::runtime_error if they can't be read
/// @param so_far  checksum of the values before these; 0 for none
[[nodiscard]] std::uint32_t checksum_of_box(hid_t dataset, const hdf5::Hyperslab& box, std::uint32_t so_far = 0);

/// The checksums of the first `rows` rows, from their values.
/// @return [full pieces + 1], as checksums_of_pieces() (checksum.hpp); -1 for a piece that can't be read
[[nodiscard]] std::vector<std::int64_t> computed_checksums(hid_t table, std::int64_t rows, std::int64_t piece_rows);

/// Whether HDF5 can read the rows from `begin` to before `end`, whatever their values are.
[[nodiscard]] bool can_read_rows(hid_t table, std::int64_t begin, std::int64_t end, std::int64_t piece_rows);

/// The checksums of all rows, as they are stored. @throws std::runtime_error if they can't be read
[[nodiscard]] std::vector<std::int64_t> stored_checksums(hid_t file, const std::string& path, hid_t table);

/// @throws std::runtime_error if a table has checksums and its values are others
void require_intact_table(hid_t file, const std::string& path, hid_t table);

/// CRC-32 of a list of checksums, as checkpoints contain it.
[[nodiscard]] std::int64_t digest_of(const std::vector<std::int64_t>& checksums);

}  // namespace idiophone::files
