#include "mesh_table_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "idiophone/files/attributes.hpp"
#include "idiophone/files/format.hpp"

namespace idiophone::mesh {

void refuse_table(const std::string& path, const std::string& why) {
  throw std::runtime_error(fmt::format("{} {}: the mesh is not valid", path, why));
}

void require_numbers(const std::string& path, std::span<const Index> numbers, std::size_t count) {
  const auto wrong =
      std::ranges::find_if(numbers, [&](Index number) { return number < 0 || std::cmp_greater_equal(number, count); });
  if (wrong != numbers.end()) {
    refuse_table(path, fmt::format("has the number {}, but there are {} to choose from", *wrong, count));
  }
}

void require_checksum(const std::string& path, std::int64_t promised, std::uint32_t found) {
  if (promised != std::int64_t{found}) {
    throw std::runtime_error(fmt::format("{} does not match its checksum: the file is damaged", path));
  }
}

MeshTables::MeshTables(const std::filesystem::path& path) : file_(hdf5::open_for_reading(path)) {
  files::check_format(file_.id(), files::mesh_format, path);
}

Index MeshTables::rows(const std::string& path, int width) const {
  const auto dataset = hdf5::open_dataset(file(), path);
  const hdf5::Dimensions shape = hdf5::shape_of(dataset.id());
  if (shape.size() != 2 || std::cmp_not_equal(shape[1], width)) {
    refuse_table(path, fmt::format("is no table of {} columns", width));
  }
  const std::size_t numbers = hdf5::stored_volume(dataset.id(), hdf5::whole(dataset.id()));
  if (std::cmp_greater(numbers, std::numeric_limits<Index>::max())) {
    refuse_table(path, fmt::format("has {} numbers, more than the {} that can be counted", numbers,
                                   std::numeric_limits<Index>::max()));
  }
  return static_cast<Index>(shape[0]);
}

std::int64_t MeshTables::checksum(const std::string& path) const {
  return hdf5::integer_of(hdf5::open_dataset(file(), path).id(), files::checksum_attribute);
}

}  // namespace idiophone::mesh
