#include "idiophone/files/checksum.hpp"

#include <zlib.h>

#include <utility>

#include "idiophone/foundation/parallel/gather.hpp"

namespace idiophone::files {

std::uint32_t checksum(std::span<const std::byte> bytes, std::uint32_t so_far) {
  const auto* const begin = reinterpret_cast<const Bytef*>(bytes.data());  // NOLINT(*-reinterpret-cast): zlib's bytes
  return bytes.empty() ? so_far : static_cast<std::uint32_t>(crc32_z(so_far, begin, bytes.size()));
}

std::uint32_t checksum_of_blocks(std::span<const std::byte> block, MPI_Comm communicator, std::uint32_t so_far) {
  const std::pair<std::uint32_t, std::size_t> own = {checksum(block), block.size()};
  uLong combined = so_far;
  for (const auto& [sum, size] : parallel::gather(own, communicator)) {
    combined = crc32_combine(combined, sum, static_cast<z_off_t>(size));
  }
  return static_cast<std::uint32_t>(combined);
}

std::vector<std::uint32_t> checksums_of_rows(std::span<const std::byte> blocks, std::size_t rows,
                                             MPI_Comm communicator) {
  const std::size_t size = rows == 0 ? 0 : blocks.size() / rows;
  std::vector<std::uint32_t> own;
  for (std::size_t row = 0; row < rows; ++row) {
    own.push_back(checksum(blocks.subspan(row * size, size)));
  }
  const auto sums = parallel::gather_all<std::uint32_t>(own, communicator).values;
  std::vector<std::uint32_t> combined(rows, 0);
  std::size_t next = 0;
  for (const std::size_t bytes : parallel::gather(size, communicator)) {
    const uLong append = crc32_combine_gen(static_cast<z_off_t>(bytes));
    for (auto& sum : combined) {
      sum = static_cast<std::uint32_t>(crc32_combine_op(sum, sums[next++], append));
    }
  }
  return combined;
}

std::vector<std::int64_t> checksums_of_pieces(std::uint32_t rest, std::int64_t rest_rows,
                                              std::span<const std::uint32_t> rows, std::size_t row_bytes,
                                              std::int64_t piece_rows) {
  const uLong append = crc32_combine_gen(static_cast<z_off_t>(row_bytes));
  std::vector<std::int64_t> pieces;
  for (const std::uint32_t row : rows) {
    rest = static_cast<std::uint32_t>(crc32_combine_op(rest, row, append));
    if (++rest_rows == piece_rows) {
      pieces.push_back(std::exchange(rest, 0));
      rest_rows = 0;
    }
  }
  pieces.push_back(rest);
  return pieces;
}

}  // namespace idiophone::files
