#include "idiophone/files/table_checksums.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "idiophone/files/attributes.hpp"
#include "idiophone/files/checksum.hpp"
#include "idiophone/files/hdf5_dataset.hpp"
#include "idiophone/files/hdf5_group.hpp"

namespace idiophone::files {

namespace {

constexpr hsize_t checksums_per_chunk = room_for_checksums / sizeof(std::int64_t);
constexpr const char* piece_attribute = "rows_per_checksum";

}  // namespace

hdf5::Identifier create_checked_table(hid_t file, const std::string& path, hid_t type, const hdf5::Dimensions& row,
                                      hsize_t piece_rows) {
  auto table = hdf5::create_table(file, path, type, row, piece_rows);
  hdf5::put(table.id(), piece_attribute, static_cast<std::int64_t>(piece_rows));
  hdf5::put(table.id(), checksum_attribute, std::int64_t{0});
  return table;
}

void cut_checksums(hid_t file, const std::string& path, hsize_t full_pieces) {
  const std::string checksums = checksums_group + path;
  if (full_pieces > 0) {
    hdf5::set_rows(hdf5::open_dataset(file, checksums).id(), full_pieces);
  } else if (hdf5::exists(file, checksums)) {
    hdf5::remove(file, checksums);
  }
}

hdf5::Identifier open_or_create_checksums(hid_t file, const std::string& path) {
  const std::string checksums = checksums_group + path;
  return hdf5::exists(file, checksums) ? hdf5::open_dataset(file, checksums)
                                       : hdf5::create_table(file, checksums, H5T_NATIVE_INT64, {}, checksums_per_chunk);
}

std::int64_t piece_rows_of(hid_t table) {
  return hdf5::has(table, piece_attribute) ? std::max<std::int64_t>(hdf5::integer_of(table, piece_attribute), 1) : 0;
}

std::uint32_t checksum_of_box(hid_t dataset, const hdf5::Hyperslab& box, std::uint32_t so_far) {
  const hdf5::Identifier type(H5Dget_type(dataset), H5Tclose, "HDF5 type");
  std::vector<std::byte> bytes(hdf5::stored_volume(dataset, box) * H5Tget_size(type.id()));
  hdf5::read_bytes(dataset, box, type.id(), bytes.data());
  return checksum(bytes, so_far);
}

std::vector<std::int64_t> computed_checksums(hid_t table, std::int64_t rows, std::int64_t piece_rows) {
  std::vector<std::int64_t> sums;
  for (std::int64_t row = 0; row <= rows; row += piece_rows) {
    const auto count = static_cast<hsize_t>(std::min(piece_rows, rows - row));
    try {
      sums.push_back(checksum_of_box(table, hdf5::rows_of(table, static_cast<hsize_t>(row), count)));
    } catch (const std::runtime_error&) {
      sums.push_back(-1);
    }
  }
  return sums;
}

bool can_read_rows(hid_t table, std::int64_t begin, std::int64_t end, std::int64_t piece_rows) {
  try {
    for (std::int64_t row = begin; row < end; row += piece_rows) {
      const auto count = static_cast<hsize_t>(std::min(piece_rows, end - row));
      static_cast<void>(checksum_of_box(table, hdf5::rows_of(table, static_cast<hsize_t>(row), count)));
    }
  } catch (const std::runtime_error&) {
    return false;
  }
  return true;
}

std::vector<std::int64_t> stored_checksums(hid_t file, const std::string& path, hid_t table) {
  std::vector<std::int64_t> sums;
  if (hdf5::exists(file, checksums_group + path)) {
    const auto full = hdf5::open_dataset(file, checksums_group + path);
    sums = hdf5::read<std::int64_t>(full.id(), hdf5::whole(full.id()));
  }
  sums.push_back(hdf5::integer_of(table, checksum_attribute));
  return sums;
}

void require_intact_table(hid_t file, const std::string& path, hid_t table) {
  const std::int64_t piece_rows = piece_rows_of(table);
  if (piece_rows > 0) {
    const auto rows = static_cast<std::int64_t>(hdf5::row_count(table));
    if (computed_checksums(table, rows, piece_rows) != stored_checksums(file, path, table)) {
      throw std::runtime_error(fmt::format("{} is damaged; idiophone info --verify shows from which time on", path));
    }
  }
}

std::int64_t digest_of(const std::vector<std::int64_t>& checksums) {
  return checksum(std::as_bytes(std::span(checksums)));
}

}  // namespace idiophone::files
