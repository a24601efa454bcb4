#pragma once
// Whole datasets written by all ranks, one block of rows each, or by rank 0, with their checksum as an attribute. All
// collective; errors reach all ranks.

#include <string>
#include <vector>

#include "idiophone/files/attributes.hpp"
#include "idiophone/files/checksum.hpp"
#include "idiophone/files/hdf5_dataset.hpp"
#include "idiophone/foundation/parallel/broadcast.hpp"
#include "idiophone/foundation/parallel/errors.hpp"
#include "idiophone/foundation/parallel/rows.hpp"

namespace idiophone::files {

/// The rows of this rank's block, in a table of rows of this width.
[[nodiscard]] inline hdf5::Hyperslab block_of(const parallel::Rows& rows, int width) {
  return {.begin = {static_cast<hsize_t>(rows.block_begin()), 0},
          .size = {static_cast<hsize_t>(rows.block_rows()), static_cast<hsize_t>(width)}};
}

/// Writes a dataset's checksum as its attribute. @return the checksum
inline std::uint32_t put_checksum(const hdf5::Identifier& dataset, std::uint32_t sum, MPI_Comm communicator) {
  parallel::collectively(communicator, [&] { hdf5::put(dataset.id(), checksum_attribute, std::int64_t{sum}); });
  return sum;
}

/// Creates a dataset [global rows x width] and writes the ranks' rows into it.
/// @return its checksum
template <class T>
std::uint32_t write_rows(hid_t file, const std::string& path, const parallel::Rows& rows, int width,
                         std::span<const T> values) {
  const auto block = rows.to_blocks(values, width);
  hdf5::Identifier dataset;
  parallel::collectively(rows.communicator(), [&] {
    dataset = hdf5::create_dataset(file, path, hdf5::type_of<T>(),
                                   {static_cast<hsize_t>(rows.global_rows()), static_cast<hsize_t>(width)});
  });
  parallel::on_root(rows.communicator(),
                    [&] { hdf5::reserve(file, hdf5::volume(hdf5::shape_of(dataset.id())) * sizeof(T)); });
  parallel::collectively(rows.communicator(), [&] {
    hdf5::write(dataset.id(), block_of(rows, width), std::span<const T>(block), hdf5::Transfer::together);
  });
  return put_checksum(dataset, checksum_of_blocks(std::as_bytes(std::span(block)), rows.communicator()),
                      rows.communicator());
}

/// Creates a dataset [values] and writes rank 0's values into it; the other ranks' are ignored.
/// @return its checksum
template <class T>
std::uint32_t write_from_rank_0(hid_t file, const std::string& path, std::span<const T> values, MPI_Comm communicator) {
  const hsize_t size = parallel::from_root(values.size(), communicator);
  hdf5::Identifier dataset;
  parallel::collectively(communicator, [&] { dataset = hdf5::create_dataset(file, path, hdf5::type_of<T>(), {size}); });
  parallel::on_root(communicator,
                    [&] { hdf5::write(dataset.id(), hdf5::whole(dataset.id()), values, hdf5::Transfer::alone); });
  return put_checksum(dataset, parallel::from_root(checksum(std::as_bytes(values)), communicator), communicator);
}

}  // namespace idiophone::files
