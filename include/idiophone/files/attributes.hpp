#pragma once
// Attributes and texts of HDF5 files. In a file that is open on all ranks, writing calls are collective, with the same
// values on every rank.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "idiophone/files/hdf5.hpp"

namespace idiophone::hdf5 {

/// Writes a new attribute. @throws std::runtime_error if there is one already, or HDF5 can't.
void put(hid_t object, const std::string& name, const std::string& text);
void put(hid_t object, const std::string& name, const std::vector<std::string>& texts);
void put(hid_t object, const std::string& name, std::int64_t number);
void put(hid_t object, const std::string& name, double number);
void put(hid_t object, const std::string& name, const std::vector<std::array<double, 3>>& points);

/// Replaces an existing number.
void replace(hid_t object, const std::string& name, std::int64_t number);

/// The data space of an open attribute.
/// @throws std::runtime_error if it has more values than an attribute can have: a damaged size must not fill the memory
[[nodiscard]] Identifier space_of_attribute(hid_t attribute, const std::string& name);

/// The names of all attributes, sorted.
[[nodiscard]] std::vector<std::string> attribute_names(hid_t object);
/// @throws std::runtime_error if the attributes are damaged.
[[nodiscard]] bool has(hid_t object, const std::string& name);
/// @throws std::runtime_error if there is no such attribute or it holds something else.
[[nodiscard]] std::string text_of(hid_t object, const std::string& name);
[[nodiscard]] std::vector<std::string> texts_of(hid_t object, const std::string& name);
[[nodiscard]] std::int64_t integer_of(hid_t object, const std::string& name);
[[nodiscard]] double number_of(hid_t object, const std::string& name);
[[nodiscard]] std::vector<std::array<double, 3>> points_of(hid_t object, const std::string& name);

/// A dataset of texts, the same on all ranks, with their checksum. For texts that may be longer than an attribute's
/// 64 kB. Collective.
void put_dataset(hid_t file, const std::string& path, const std::vector<std::string>& texts, MPI_Comm communicator);
[[nodiscard]] std::vector<std::string> texts_in(hid_t file, const std::string& path);
/// @throws std::runtime_error if it is not one text
[[nodiscard]] std::string text_in(hid_t file, const std::string& path);

}  // namespace idiophone::hdf5
