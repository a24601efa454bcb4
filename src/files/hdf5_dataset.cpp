#include "idiophone/files/hdf5_dataset.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <stdexcept>

namespace idiophone::hdf5 {

namespace {

Identifier make_space(const Dimensions& shape, const hsize_t* limits = nullptr) {
  return {H5Screate_simple(static_cast<int>(shape.size()), shape.data(), limits), H5Sclose, "HDF5 data space"};
}

/// Creates parent groups. No times are stored, so that equal runs give equal files.
Identifier create(hid_t file, const std::string& path, hid_t type, const Identifier& space,
                  const Identifier& creation) {
  const auto links = make_property_list(H5P_LINK_CREATE);
  check(H5Pset_create_intermediate_group(links.id(), 1), path);
  check(H5Pset_obj_track_times(creation.id(), false), path);
  check(H5Pset_fill_time(creation.id(), H5D_FILL_TIME_NEVER), path);
  return {H5Dcreate2(file, path.c_str(), type, space.id(), links.id(), creation.id(), H5P_DEFAULT), H5Dclose,
          fmt::format("can't create dataset {}", path)};
}

Identifier space_of(hid_t dataset) {
  return {H5Dget_space(dataset), H5Sclose, "HDF5 data space"};
}

/// The data spaces of a hyperslab in the file and in memory.
std::pair<Identifier, Identifier> select(hid_t dataset, const Hyperslab& box) {
  auto file = space_of(dataset);
  auto memory = make_space(box.size);
  if (volume(box.size) == 0) {
    check(H5Sselect_none(file.id()), "HDF5 selection");
    check(H5Sselect_none(memory.id()), "HDF5 selection");
  } else {
    check(H5Sselect_hyperslab(file.id(), H5S_SELECT_SET, box.begin.data(), nullptr, box.size.data(), nullptr),
          "HDF5 selection");
  }
  return {std::move(file), std::move(memory)};
}

std::string name_of(hid_t object) {
  std::string name(std::max<ssize_t>(H5Iget_name(object, nullptr, 0), 0), ' ');
  H5Iget_name(object, name.data(), name.size() + 1);
  return name;
}

/// The shape of a dataset that has rows. @throws std::runtime_error if it is a scalar
Dimensions shape_of_table(hid_t dataset) {
  auto shape = shape_of(dataset);
  if (shape.empty()) {
    throw std::runtime_error(fmt::format("dataset {} has no rows", name_of(dataset)));
  }
  return shape;
}

}  // namespace

hsize_t volume(const Dimensions& shape) {
  return std::accumulate(shape.begin(), shape.end(), hsize_t{1}, std::multiplies<>());
}

Identifier create_dataset(hid_t file, const std::string& path, hid_t type, const Dimensions& shape) {
  const auto creation = make_property_list(H5P_DATASET_CREATE);
  check(H5Pset_alloc_time(creation.id(), H5D_ALLOC_TIME_EARLY), path);
  return create(file, path, type, make_space(shape), creation);
}

Identifier create_table(hid_t file, const std::string& path, hid_t type, const Dimensions& row,
                        hsize_t rows_per_chunk) {
  Dimensions shape = row, limits = row, chunk = row;
  shape.insert(shape.begin(), 0);
  limits.insert(limits.begin(), H5S_UNLIMITED);
  chunk.insert(chunk.begin(), rows_per_chunk);
  const auto creation = make_property_list(H5P_DATASET_CREATE);
  check(H5Pset_chunk(creation.id(), static_cast<int>(chunk.size()), chunk.data()), path);
  return create(file, path, type, make_space(shape, limits.data()), creation);
}

Identifier open_dataset(hid_t file, const std::string& path) {
  return {H5Dopen2(file, path.c_str(), H5P_DEFAULT), H5Dclose, fmt::format("can't open dataset {}", path)};
}

Dimensions shape_of(hid_t dataset) {
  return shape_of_space(space_of(dataset).id());
}

Dimensions shape_of_space(hid_t space) {
  Dimensions shape(static_cast<std::size_t>(std::max(H5Sget_simple_extent_ndims(space), 0)));
  H5Sget_simple_extent_dims(space, shape.data(), nullptr);
  return shape;
}

hsize_t row_count(hid_t dataset) {
  return shape_of_table(dataset)[0];
}

bool can_grow(hid_t dataset) {
  const auto space = space_of(dataset);
  Dimensions limits(static_cast<std::size_t>(std::max(H5Sget_simple_extent_ndims(space.id()), 0)));
  H5Sget_simple_extent_dims(space.id(), nullptr, limits.data());
  return !limits.empty() && limits[0] == H5S_UNLIMITED;
}

void set_rows(hid_t dataset, hsize_t rows) {
  auto shape = shape_of_table(dataset);
  shape[0] = rows;
  check(H5Dset_extent(dataset, shape.data()), fmt::format("can't resize dataset {}", name_of(dataset)));
}

Hyperslab whole(hid_t dataset) {
  auto shape = shape_of(dataset);
  return {Dimensions(shape.size(), 0), shape};
}

Hyperslab rows_of(hid_t dataset, hsize_t begin, hsize_t size) {
  Hyperslab box{.begin = {}, .size = shape_of_table(dataset)};
  box.begin.resize(box.size.size());
  box.begin[0] = begin;
  box.size[0] = size;
  return box;
}

std::size_t bytes_of_row(hid_t dataset) {
  const Identifier type(H5Dget_type(dataset), H5Tclose, "HDF5 type");
  return volume(rows_of(dataset, 0, 1).size) * H5Tget_size(type.id());
}

void write_bytes(hid_t dataset, const Hyperslab& box, hid_t type, const void* values, Transfer transfer) {
  const auto [file, memory] = select(dataset, box);
  const auto list = make_property_list(H5P_DATASET_XFER);
  if (transfer == Transfer::together) {
    check(H5Pset_dxpl_mpio(list.id(), H5FD_MPIO_COLLECTIVE), "HDF5 over MPI");
  }
  check(H5Dwrite(dataset, type, memory.id(), file.id(), list.id(), values),
        fmt::format("can't write dataset {}", name_of(dataset)));
}

void read_bytes(hid_t dataset, const Hyperslab& box, hid_t type, void* values) {
  const auto [file, memory] = select(dataset, box);
  check(H5Dread(dataset, type, memory.id(), file.id(), H5P_DEFAULT, values),
        fmt::format("can't read dataset {}", name_of(dataset)));
}

std::size_t stored_volume(hid_t dataset, const Hyperslab& box) {
  constexpr double small = 64e6;        // bytes that any machine has
  constexpr double compression = 2000;  // more than gzip reaches
  const Identifier type(H5Dget_type(dataset), H5Tclose, "HDF5 type");
  const double bytes =
      std::accumulate(box.size.begin(), box.size.end(), static_cast<double>(H5Tget_size(type.id())),
                      [](double product, hsize_t size) { return product * static_cast<double>(size); });
  if (bytes > small && bytes > compression * static_cast<double>(H5Dget_storage_size(dataset))) {
    throw std::runtime_error(fmt::format("dataset {} has {:.3g} bytes, but only {} are in the file", name_of(dataset),
                                         bytes, H5Dget_storage_size(dataset)));
  }
  return volume(box.size);
}

hsize_t growth(hid_t table, hsize_t rows, hsize_t more) {
  constexpr hsize_t index_of_a_chunk = 1024;  // more than it takes, bytes
  const Identifier creation(H5Dget_create_plist(table), H5Pclose, "HDF5 property list");
  Dimensions chunk(shape_of(table).size());
  check(H5Pget_chunk(creation.id(), static_cast<int>(chunk.size()), chunk.data()), "HDF5 chunks");
  const auto chunks = [&](hsize_t count) { return (count + chunk[0] - 1) / chunk[0]; };
  return (chunks(rows + more) - chunks(rows)) * (chunk[0] * bytes_of_row(table) + index_of_a_chunk);
}

}  // namespace idiophone::hdf5
