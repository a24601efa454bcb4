#pragma once
// HDF5's C interface: identifiers with automatic closing, and calls that throw. A file is open either on all ranks of
// a communicator (every call that changes the file's structure is then collective) or on one process, read-only.

#include <hdf5.h>
#include <mpi.h>

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace idiophone::store::hdf5 {

/// Owns one HDF5 identifier.
class Identifier {
 public:
  using Close = herr_t (*)(hid_t);

  Identifier() = default;
  /// @throws std::runtime_error "<action>: <HDF5's reason>" if the identifier is an error
  Identifier(hid_t id, Close closer, const std::string& action);
  Identifier(Identifier&& other) noexcept : id_(std::exchange(other.id_, H5I_INVALID_HID)), close_(other.close_) {}
  Identifier& operator=(Identifier&& other) noexcept;
  Identifier(const Identifier&) = delete;
  Identifier& operator=(const Identifier&) = delete;
  ~Identifier() { release(); }

  [[nodiscard]] hid_t id() const { return id_; }
  [[nodiscard]] bool open() const { return id_ >= 0; }
  /// Closes now. @throws std::runtime_error if that fails, e.g. because the disk is full
  void close(const std::string& action);

 private:
  void release() noexcept;

  hid_t id_ = H5I_INVALID_HID;
  Close close_ = nullptr;
};

/// @throws std::runtime_error "<action>: <HDF5's reason>" if the status is an error
void check(herr_t status, const std::string& action);

/// Creates or overwrites. The file has the format of HDF5 1.10, whose metadata has checksums. Collective; throws on all
/// ranks.
[[nodiscard]] Identifier create_file(const std::filesystem::path& path, MPI_Comm communicator);
/// Opens for reading and writing. Collective; throws on all ranks.
[[nodiscard]] Identifier open_file(const std::filesystem::path& path, MPI_Comm communicator);
/// Opens for reading, in this process alone.
[[nodiscard]] Identifier open_for_reading(const std::filesystem::path& path);

/// Allocates disk space in advance. Call on rank 0 before ranks write together: MPI's file routines can hang if the
/// disk is full. Closing the file frees unused space.
/// @throws std::runtime_error if the disk is full (with the system's reason)
void reserve(hid_t file, hsize_t bytes);

/// Disk space that a table (create_table) takes for more rows, its index included: nothing while its last chunk has
/// room, bytes.
[[nodiscard]] hsize_t growth(hid_t table, hsize_t rows, hsize_t more);

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
/// Whether a link of this path is there; false also where one of its groups is not.
[[nodiscard]] bool exists(hid_t file, const std::string& path);

/// Removes a dataset. @throws std::runtime_error if it can't
void remove(hid_t file, const std::string& path);
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

/// A group of a file that is open for writing. Creates it and its parents if necessary.
[[nodiscard]] Identifier open_group(hid_t file, const std::string& path);

/// A dataset or group within a group.
struct Entry {
  std::string name;
  bool is_group = false;
};

/// Order of a list: HDF5's own. If HDF5 1.10 fails to list a damaged group by name, it frees pointers that it has not
/// set.
inline constexpr H5_iter_order_t any_order = H5_ITER_NATIVE;

/// Names of the entries of a group, sorted; does not open them.
[[nodiscard]] std::vector<std::string> names_in(hid_t group);
/// The entries of a group, sorted by name.
[[nodiscard]] std::vector<Entry> entries_of(hid_t group);

/// Paths of all datasets below a group ("/" for all), sorted; none if there is no such group.
[[nodiscard]] std::vector<std::string> datasets_below(hid_t file, const std::string& group);

}  // namespace idiophone::store::hdf5
