#include "hdf5_mutations.hpp"

#include <hdf5.h>

#include <array>
#include <limits>
#include <string>
#include <vector>

namespace idiophone::mutants {

namespace {

constexpr std::array hostile_doubles = {0.0,
                                        -1.0,
                                        0.5,
                                        2.0,
                                        1e-310,
                                        1e10,
                                        1e30,
                                        1e300,
                                        -1e300,
                                        std::numeric_limits<double>::quiet_NaN(),
                                        std::numeric_limits<double>::infinity(),
                                        2147483647.0,
                                        -2147483648.0,
                                        9e18};

double hostile_number(Random& random) {
  return hostile_doubles[below(hostile_doubles.size(), random)];
}

/// Some have more values than any memory has room for.
std::vector<hsize_t> hostile_shape(Random& random) {
  static const std::array<std::vector<hsize_t>, 11> shapes = {
      {{}, {0}, {1}, {3}, {1000}, {0, 3}, {5, 3}, {3, 0}, {2, 2, 2, 2}, {hsize_t{1} << 40U}, {hsize_t{1} << 62U, 3}}};
  return shapes[below(shapes.size(), random)];
}

hid_t hostile_type(Random& random) {
  switch (below(6, random)) {
    case 0:
      return H5Tcopy(H5T_NATIVE_INT32);
    case 1:
      return H5Tcopy(H5T_NATIVE_FLOAT);
    case 2:
      return H5Tcopy(H5T_NATIVE_UINT64);
    case 3:
    case 4: {
      const hid_t text = H5Tcopy(H5T_C_S1);
      H5Tset_size(text, below(2, random) == 0 ? H5T_VARIABLE : 4);
      return text;
    }
    default:
      return H5Tcopy(H5T_NATIVE_DOUBLE);
  }
}

using Paths = std::vector<std::string>;

Paths paths_in(hid_t file) {
  Paths paths;
  const auto collect = [](hid_t /*group*/, const char* name, const auto* /*object*/, void* list) -> herr_t {
    static_cast<Paths*>(list)->emplace_back(name);
    return 0;
  };
  H5Ovisit2(file, H5_INDEX_NAME, H5_ITER_INC, collect, &paths, H5O_INFO_BASIC);
  return paths;
}

Paths attributes_of(hid_t object) {
  Paths names;
  const auto collect = [](hid_t /*object*/, const char* name, const H5A_info_t* /*attribute*/, void* list) -> herr_t {
    static_cast<Paths*>(list)->emplace_back(name);
    return 0;
  };
  H5Aiterate2(object, H5_INDEX_NAME, H5_ITER_INC, nullptr, collect, &names);
  return names;
}

void remove_checksums(hid_t file) {
  for (const auto& path : paths_in(file)) {
    const hid_t object = H5Oopen(file, path.c_str(), H5P_DEFAULT);
    for (const char* name : {"crc32", "rows_per_checksum"}) {
      if (H5Aexists(object, name) > 0) {
        H5Adelete(object, name);
      }
    }
    H5Oclose(object);
  }
  if (H5Lexists(file, "checksums", H5P_DEFAULT) > 0) {
    H5Ldelete(file, "checksums", H5P_DEFAULT);
  }
}

void replace_attribute(hid_t object, const std::string& name, Random& random) {
  H5Adelete(object, name.c_str());
  if (below(3, random) == 0) {
    return;
  }
  const bool is_number = below(2, random) == 0;
  const std::vector<hsize_t> shape = is_number ? std::vector<hsize_t>() : hostile_shape(random);
  const hid_t type = is_number ? H5Tcopy(H5T_NATIVE_DOUBLE) : hostile_type(random);
  const hid_t space = H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr);
  const hid_t attribute = H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT);
  if (const double value = hostile_number(random); is_number) {
    H5Awrite(attribute, H5T_NATIVE_DOUBLE, &value);
  }
  H5Aclose(attribute);
  H5Sclose(space);
  H5Tclose(type);
}

/// Another dataset of the same name, in pieces of which none is stored.
void replace_dataset(hid_t file, const std::string& path, Random& random) {
  H5Ldelete(file, path.c_str(), H5P_DEFAULT);
  const auto shape = hostile_shape(random);
  const hid_t type = hostile_type(random);
  const hid_t space = H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr);
  const hid_t list = H5Pcreate(H5P_DATASET_CREATE);
  if (!shape.empty()) {
    const std::vector<hsize_t> piece(shape.size(), 1);
    H5Pset_chunk(list, static_cast<int>(piece.size()), piece.data());
  }
  H5Dclose(H5Dcreate2(file, path.c_str(), type, space, H5P_DEFAULT, list, H5P_DEFAULT));
  H5Pclose(list);
  H5Sclose(space);
  H5Tclose(type);
}

/// Does nothing to a dataset that an earlier change has made too large to read.
void overwrite_values(hid_t dataset, Random& random) {
  constexpr std::size_t most_values = 1'000'000;
  const hid_t space = H5Dget_space(dataset), type = H5Dget_type(dataset);
  const auto count = static_cast<std::size_t>(H5Sget_simple_extent_npoints(space));
  if (H5Tget_class(type) != H5T_STRING && count > 0 && count <= most_values) {
    std::vector<double> values(count);
    H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    for (std::size_t changes = 1 + below(3, random); changes > 0; --changes) {
      values[below(count, random)] = hostile_number(random);
    }
    H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
  }
  H5Tclose(type);
  H5Sclose(space);
}

/// Whether HDF5 writes all pieces of a dataset as soon as it has them.
bool is_allocated_early(hid_t dataset) {
  const hid_t list = H5Dget_create_plist(dataset);
  H5D_alloc_time_t time = H5D_ALLOC_TIME_DEFAULT;
  H5Pget_alloc_time(list, &time);
  H5Pclose(list);
  return time == H5D_ALLOC_TIME_EARLY;
}

/// Fewer rows or more. Does nothing to a dataset of fixed size.
void change_rows(hid_t dataset, Random& random) {
  const hid_t space = H5Dget_space(dataset);
  std::vector<hsize_t> shape(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space)));
  H5Sget_simple_extent_dims(space, shape.data(), nullptr);
  if (!shape.empty()) {
    const bool huge = below(3, random) == 0 && !is_allocated_early(dataset);  // the disk would be full
    shape[0] = huge ? hsize_t{1} << 40U : below(2 * shape[0] + 1, random);
    H5Dset_extent(dataset, shape.data());
  }
  H5Sclose(space);
}

void change_link(hid_t file, const std::string& path, const Paths& all, Random& random) {
  H5Ldelete(file, path.c_str(), H5P_DEFAULT);
  switch (below(4, random)) {
    case 0:
      H5Lcreate_soft("/nowhere", file, path.c_str(), H5P_DEFAULT, H5P_DEFAULT);
      break;
    case 1:
      H5Lcreate_hard(file, all[below(all.size(), random)].c_str(), file, path.c_str(), H5P_DEFAULT, H5P_DEFAULT);
      break;
    case 2:
      H5Gclose(H5Gcreate2(file, path.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
      break;
    default:
      break;
  }
}

void change_dataset(hid_t file, const std::string& path, hid_t dataset, const Paths& all, Random& random) {
  switch (below(6, random)) {
    case 0:
      change_link(file, path, all, random);
      break;
    case 1:
      replace_dataset(file, path, random);
      break;
    case 2:
      change_rows(dataset, random);
      break;
    default:
      overwrite_values(dataset, random);
  }
}

void change_object(hid_t file, Random& random) {
  const Paths all = paths_in(file);
  if (all.empty()) {
    return;
  }
  const std::string& path = all[below(all.size(), random)];
  const hid_t object = H5Oopen(file, path.c_str(), H5P_DEFAULT);
  const Paths attributes = attributes_of(object);
  if (!attributes.empty() && below(2, random) == 0) {
    replace_attribute(object, attributes[below(attributes.size(), random)], random);
  } else if (H5Iget_type(object) == H5I_DATASET) {
    change_dataset(file, path, object, all, random);
  } else if (path != "." && below(4, random) == 0) {
    change_link(file, path, all, random);
  }
  H5Oclose(object);
}

}  // namespace

void mutate_hdf5(const std::filesystem::path& path, Random& random) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // not all changes are possible
  const hid_t list = H5Pcreate(H5P_FILE_ACCESS);
  H5Pset_libver_bounds(list, H5F_LIBVER_V110, H5F_LIBVER_V110);
  H5Pset_fclose_degree(list, H5F_CLOSE_STRONG);
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDWR, list);
  H5Pclose(list);
  if (file < 0) {
    return;
  }
  if (below(4, random) > 0) {
    remove_checksums(file);
  }
  for (std::size_t changes = 1 + below(3, random); changes > 0; --changes) {
    change_object(file, random);
  }
  H5Fclose(file);
}

}  // namespace idiophone::mutants
