#pragma once
// CRC-32 (zlib) of bytes on one rank, or of the concatenated bytes of all ranks.

#include <mpi.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace idiophone::files {

/// The attribute with the checksum of a dataset.
inline constexpr const char* checksum_attribute = "crc32";

/// @param so_far  checksum of the bytes before these; 0 for none
[[nodiscard]] std::uint32_t checksum(std::span<const std::byte> bytes, std::uint32_t so_far = 0);

/// Checksum of the concatenated blocks of all ranks, on all ranks. Collective.
/// @param so_far  checksum of the bytes before these; 0 for none
[[nodiscard]] std::uint32_t checksum_of_blocks(std::span<const std::byte> block, MPI_Comm communicator,
                                               std::uint32_t so_far = 0);

/// Checksum of each row of which the ranks have blocks side by side, [rows] on all ranks. Collective.
/// @param blocks  this rank's blocks, of equal size, row after row
[[nodiscard]] std::vector<std::uint32_t> checksums_of_rows(std::span<const std::byte> blocks, std::size_t rows,
                                                           MPI_Comm communicator);

/// Checksums of pieces of so many rows, the last of which is not full, from the checksums of rows.
/// @param rest       checksum of the last piece so far
/// @param rest_rows  rows in it, fewer than `piece_rows`
/// @param rows       checksum of each row that comes next
/// @param row_bytes  bytes of a row
/// @return [full pieces + 1]; 0 for a last piece without rows
[[nodiscard]] std::vector<std::int64_t> checksums_of_pieces(std::uint32_t rest, std::int64_t rest_rows,
                                                            std::span<const std::uint32_t> rows, std::size_t row_bytes,
                                                            std::int64_t piece_rows);

}  // namespace idiophone::files
