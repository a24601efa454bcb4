#pragma once
// Datasets of an HDF5 file: tables that grow by rows, and hyperslabs that are read and written.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "idiophone/files/hdf5.hpp"

namespace idiophone::hdf5 {

/// The type in memory and in files.
template <class T>
[[nodiscard]] hid_t type_of();
template <>
[[nodiscard]] inline hid_t type_of<double>() {
  return H5T_NATIVE_DOUBLE;
}
template <>
[[nodiscard]] inline hid_t type_of<float>() {
  return H5T_NATIVE_FLOAT;
}
template <>
[[nodiscard]] inline hid_t type_of<std::int32_t>() {
  return H5T_NATIVE_INT32;
}
template <>
[[nodiscard]] inline hid_t type_of<std::int64_t>() {
  return H5T_NATIVE_INT64;
}
template <>
[[nodiscard]] inline hid_t type_of<char>() {
  return H5T_NATIVE_CHAR;
}

using Dimensions = std::vector<hsize_t>;

/// Number of values.
[[nodiscard]] hsize_t volume(const Dimensions& shape);

/// A dataset of fixed shape. Creates its groups if necessary and allocates its space.
[[nodiscard]] Identifier create_dataset(hid_t file, const std::string& path, hid_t type, const Dimensions& shape);
/// A dataset without rows, [0 x row...], that can grow.
[[nodiscard]] Identifier create_table(hid_t file, const std::string& path, hid_t type, const Dimensions& row,
                                      hsize_t rows_per_chunk);
[[nodiscard]] Identifier open_dataset(hid_t file, const std::string& path);
[[nodiscard]] Dimensions shape_of(hid_t dataset);
[[nodiscard]] Dimensions shape_of_space(hid_t space);
/// Number of rows. @throws std::runtime_error if the dataset is a single value
[[nodiscard]] hsize_t row_count(hid_t dataset);
[[nodiscard]] bool can_grow(hid_t dataset);
/// Changes the number of rows; new ones have no defined content.
void set_rows(hid_t dataset, hsize_t rows);

/// A hyperslab of a dataset.
struct Hyperslab {
  Dimensions begin, size;
};
/// A whole dataset.
[[nodiscard]] Hyperslab whole(hid_t dataset);
/// The first `size` rows from `begin` on.
[[nodiscard]] Hyperslab rows_of(hid_t dataset, hsize_t begin, hsize_t size);
/// Bytes of a row as it is stored.
[[nodiscard]] std::size_t bytes_of_row(hid_t dataset);

enum class Transfer { alone, together };  ///< by this process alone, or collectively, each with its own hyperslab

void write_bytes(hid_t dataset, const Hyperslab& box, hid_t type, const void* values, Transfer transfer);
void read_bytes(hid_t dataset, const Hyperslab& box, hid_t type, void* values);

/// Number of values in a box, for which memory will be allocated.
/// @throws std::runtime_error if the file is too small for them: a damaged size must not fill the memory
[[nodiscard]] std::size_t stored_volume(hid_t dataset, const Hyperslab& box);

template <class T>
void write(hid_t dataset, const Hyperslab& box, std::span<const T> values, Transfer transfer) {
  write_bytes(dataset, box, type_of<T>(), values.data(), transfer);
}

template <class T>
[[nodiscard]] std::vector<T> read(hid_t dataset, const Hyperslab& box) {
  std::vector<T> values(stored_volume(dataset, box));
  read_bytes(dataset, box, type_of<T>(), values.data());
  return values;
}

/// Disk space that a table (create_table) takes for more rows, its index included: nothing while its last chunk has
/// room, bytes.
[[nodiscard]] hsize_t growth(hid_t table, hsize_t rows, hsize_t more);

}  // namespace idiophone::hdf5
