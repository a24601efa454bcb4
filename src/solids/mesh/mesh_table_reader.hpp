#pragma once
// The tables of a mesh file, whole or some rows of them.

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "idiophone/files/checksum.hpp"
#include "idiophone/files/hdf5_dataset.hpp"
#include "idiophone/foundation/types.hpp"

namespace idiophone::mesh {

/// @param path  of the dataset that is wrong
/// @throws std::runtime_error  always
[[noreturn]] void refuse_table(const std::string& path, const std::string& why);

/// @throws std::runtime_error unless all are numbers of one of `count` things
void require_numbers(const std::string& path, std::span<const Index> numbers, std::size_t count);

/// @param path      of a dataset
/// @param promised  its checksum in the file
/// @throws std::runtime_error that says that the dataset is damaged, unless both checksums are the same
void require_checksum(const std::string& path, std::int64_t promised, std::uint32_t found);

class MeshTables {
 public:
  /// @throws std::runtime_error if the file can't be opened or is no mesh
  explicit MeshTables(const std::filesystem::path& path);

  [[nodiscard]] hid_t file() const { return file_.id(); }

  /// Rows of a table of numbers.
  /// @throws std::runtime_error unless it has `width` columns, and the numbers can be counted by an Index
  [[nodiscard]] Index rows(const std::string& path, int width) const;

  /// The checksum that the file has of a table.
  [[nodiscard]] std::int64_t checksum(const std::string& path) const;

  /// A table of numbers of type T, `width` in a row, as items of a row each, or of a number each.
  /// @throws std::runtime_error as rows(), and if it does not match its checksum
  template <class T, class Item>
  [[nodiscard]] std::vector<Item> read(const std::string& path, int width) const {
    std::vector<Item> items = read_rows<T, Item>(path, width, 0, rows(path, width));
    require_checksum(path, checksum(path), files::checksum(std::as_bytes(std::span(items))));
    return items;
  }

  /// The rows from `begin` to before `end` of a table that has them; nothing is compared with a checksum.
  template <class T, class Item>
  [[nodiscard]] std::vector<Item> read_rows(const std::string& path, int width, Index begin, Index end) const {
    const auto dataset = hdf5::open_dataset(file(), path);
    const hdf5::Hyperslab box =
        hdf5::rows_of(dataset.id(), static_cast<hsize_t>(begin), static_cast<hsize_t>(end - begin));
    std::vector<Item> items(static_cast<std::size_t>(end - begin) * width * sizeof(T) / sizeof(Item));
    hdf5::read_bytes(dataset.id(), box, hdf5::type_of<T>(), items.data());
    return items;
  }

 private:
  hdf5::Identifier file_;
};

}  // namespace idiophone::mesh
