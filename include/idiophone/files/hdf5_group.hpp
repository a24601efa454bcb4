#pragma once
// Groups of an HDF5 file: what is in them, by name.

#include <string>
#include <vector>

#include "idiophone/files/hdf5.hpp"

namespace idiophone::hdf5 {

/// Whether a link of this path is there; false also where one of its groups is not.
[[nodiscard]] bool exists(hid_t file, const std::string& path);

/// Removes a dataset. @throws std::runtime_error if it can't
void remove(hid_t file, const std::string& path);

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

}  // namespace idiophone::hdf5
