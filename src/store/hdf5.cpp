#include "hdf5.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <functional>
#include <numeric>
#include <sstream>
#include <stdexcept>
#include <system_error>

#include "idiophone/parallel/errors.hpp"

namespace idiophone::store::hdf5 {

namespace {

/// The innermost two reasons on HDF5's error stack.
std::string reason() {
  std::vector<std::string> reasons;
  const auto collect = [](unsigned /*depth*/, const H5E_error2_t* error, void* list) -> herr_t {
    static_cast<std::vector<std::string>*>(list)->emplace_back(error->desc);
    return 0;
  };
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, collect, &reasons);
  if (reasons.empty()) {
    return "unknown reason";
  }
  return reasons.size() == 1 ? reasons[0] : fmt::format("{} ({})", reasons[0], reasons[1]);
}

/// HDF5 must not print errors, as they become exceptions.
void be_quiet() {
  check(H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr), "HDF5 start");
}

Identifier make_list(hid_t list_class) {
  return {H5Pcreate(list_class), H5Pclose, "HDF5 property list"};
}

constexpr std::size_t changed_metadata_limit = 32U << 20U;  ///< bytes

/// HDF5 exchanges changed metadata between all ranks as soon as so much of it has changed, even inside an operation of
/// rank 0 alone, which then waits for the others forever. So the limit is the largest that HDF5 accepts, and files are
/// flushed long before (SharedFile).
void exchange_metadata_late(hid_t access) {
  H5AC_cache_config_t cache;
  cache.version = H5AC__CURR_CACHE_CONFIG_VERSION;
  check(H5Pget_mdc_config(access, &cache), "HDF5 file access");
  cache.dirty_bytes_threshold = changed_metadata_limit;
  check(H5Pset_mdc_config(access, &cache), "HDF5 file access");
}

/// File access on all ranks.
Identifier shared_access(MPI_Comm communicator) {
  auto access = make_list(H5P_FILE_ACCESS);
  check(H5Pset_fapl_mpio(access.id(), communicator, MPI_INFO_NULL), "HDF5 over MPI");
  check(H5Pset_fclose_degree(access.id(), H5F_CLOSE_STRONG), "HDF5 file access");
  check(H5Pset_coll_metadata_write(access.id(), true), "HDF5 file access");
  check(H5Pset_libver_bounds(access.id(), H5F_LIBVER_V110, H5F_LIBVER_V110), "HDF5 file access");
  exchange_metadata_late(access.id());
  return access;
}

int open_by_system(const std::filesystem::path& path, int flags) {
  const int file = ::open(path.c_str(), flags | O_CLOEXEC, 0666);  // NOLINT(*-vararg): POSIX
  if (file < 0) {
    throw std::runtime_error(fmt::format("can't open {}: {}", path.string(), std::system_category().message(errno)));
  }
  return file;
}

/// Throws with the system's reason if a file can't be opened; HDF5 and MPI do not give it.
void try_open(const std::filesystem::path& path, int flags) {
  ::close(open_by_system(path, flags));
}

Identifier make_space(const Dimensions& shape, const hsize_t* limits = nullptr) {
  return {H5Screate_simple(static_cast<int>(shape.size()), shape.data(), limits), H5Sclose, "HDF5 data space"};
}

/// Creates parent groups. No times are stored, so that equal runs give equal files.
Identifier create(hid_t file, const std::string& path, hid_t type, const Identifier& space,
                  const Identifier& creation) {
  const auto links = make_list(H5P_LINK_CREATE);
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

std::string path_of(hid_t file) {
  std::string path(std::max<ssize_t>(H5Fget_name(file, nullptr, 0), 0), ' ');
  H5Fget_name(file, path.data(), path.size() + 1);
  return path;
}

/// The shape of a dataset that has rows. @throws std::runtime_error if it is a scalar
Dimensions shape_of_table(hid_t dataset) {
  auto shape = shape_of(dataset);
  if (shape.empty()) {
    throw std::runtime_error(fmt::format("dataset {} has no rows", name_of(dataset)));
  }
  return shape;
}

constexpr hsize_t room_for_metadata = 1U << 20U;

}  // namespace

Identifier::Identifier(hid_t id, Close closer, const std::string& action) : id_(id), close_(closer) {
  check(id < 0 ? -1 : 0, action);
}

Identifier& Identifier::operator=(Identifier&& other) noexcept {
  if (this != &other) {
    release();
    id_ = std::exchange(other.id_, H5I_INVALID_HID);
    close_ = other.close_;
  }
  return *this;
}

void Identifier::close(const std::string& action) {
  if (open()) {
    check(close_(std::exchange(id_, H5I_INVALID_HID)), action);
  }
}

void Identifier::release() noexcept {
  if (open()) {
    close_(std::exchange(id_, H5I_INVALID_HID));
  }
}

void check(herr_t status, const std::string& action) {
  if (status < 0) {
    throw std::runtime_error(fmt::format("{}: {}", action, reason()));
  }
}

void reserve(hid_t file, hsize_t bytes) {
  if (bytes == 0) {
    return;
  }
  const auto path = path_of(file);
  const int opened = open_by_system(path, O_RDWR);
  const int error = ::posix_fallocate(opened, ::lseek(opened, 0, SEEK_END), static_cast<off_t>(bytes));
  ::close(opened);
  if (error != 0) {
    throw std::runtime_error(
        fmt::format("can't allocate another {} bytes of {}: {}", bytes, path, std::system_category().message(error)));
  }
}

hsize_t growth(hid_t table, hsize_t rows, hsize_t more) {
  constexpr hsize_t index_of_a_chunk = 1024;  // more than it takes, bytes
  const Identifier creation(H5Dget_create_plist(table), H5Pclose, "HDF5 property list");
  Dimensions chunk(shape_of(table).size());
  check(H5Pget_chunk(creation.id(), static_cast<int>(chunk.size()), chunk.data()), "HDF5 chunks");
  const auto chunks = [&](hsize_t count) { return (count + chunk[0] - 1) / chunk[0]; };
  return (chunks(rows + more) - chunks(rows)) * (chunk[0] * bytes_of_row(table) + index_of_a_chunk);
}

Identifier create_file(const std::filesystem::path& path, MPI_Comm communicator) {
  parallel::on_root(communicator, [&] { try_open(path, O_RDWR | O_CREAT); });
  Identifier file;
  parallel::collectively(communicator, [&] {
    be_quiet();
    const auto access = shared_access(communicator);
    file = {H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.id()), H5Fclose,
            fmt::format("can't create {}", path.string())};
  });
  parallel::on_root(communicator, [&] { reserve(file.id(), room_for_metadata); });
  return file;
}

Identifier open_file(const std::filesystem::path& path, MPI_Comm communicator) {
  parallel::on_root(communicator, [&] { try_open(path, O_RDWR); });
  Identifier file;
  parallel::collectively(communicator, [&] {
    be_quiet();
    const auto access = shared_access(communicator);
    file = {H5Fopen(path.c_str(), H5F_ACC_RDWR, access.id()), H5Fclose, fmt::format("can't open {}", path.string())};
  });
  parallel::on_root(communicator, [&] { reserve(file.id(), room_for_metadata); });
  return file;
}

Identifier open_for_reading(const std::filesystem::path& path) {
  try_open(path, O_RDONLY);
  if (std::filesystem::is_directory(path)) {
    throw std::runtime_error(path.string() + " is a folder; name an HDF5 file");
  }
  be_quiet();
  return {H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose,
          fmt::format("{} is not an HDF5 file, or is damaged", path.string())};
}

hsize_t volume(const Dimensions& shape) {
  return std::accumulate(shape.begin(), shape.end(), hsize_t{1}, std::multiplies<>());
}

Identifier create_dataset(hid_t file, const std::string& path, hid_t type, const Dimensions& shape) {
  const auto creation = make_list(H5P_DATASET_CREATE);
  check(H5Pset_alloc_time(creation.id(), H5D_ALLOC_TIME_EARLY), path);
  return create(file, path, type, make_space(shape), creation);
}

Identifier create_table(hid_t file, const std::string& path, hid_t type, const Dimensions& row,
                        hsize_t rows_per_chunk) {
  Dimensions shape = row, limits = row, chunk = row;
  shape.insert(shape.begin(), 0);
  limits.insert(limits.begin(), H5S_UNLIMITED);
  chunk.insert(chunk.begin(), rows_per_chunk);
  const auto creation = make_list(H5P_DATASET_CREATE);
  check(H5Pset_chunk(creation.id(), static_cast<int>(chunk.size()), chunk.data()), path);
  return create(file, path, type, make_space(shape, limits.data()), creation);
}

bool exists(hid_t file, const std::string& path) {
  return H5Lexists(file, path.c_str(), H5P_DEFAULT) > 0;
}

void remove(hid_t file, const std::string& path) {
  check(H5Ldelete(file, path.c_str(), H5P_DEFAULT), fmt::format("can't remove {}", path));
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
  const auto list = make_list(H5P_DATASET_XFER);
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

Identifier open_group(hid_t file, const std::string& path) {
  const auto action = fmt::format("can't open group {}", path);
  Identifier group(H5Gopen2(file, "/", H5P_DEFAULT), H5Gclose, action);
  std::istringstream names(path.substr(1));
  for (std::string name; std::getline(names, name, '/');) {
    const bool exists = H5Lexists(group.id(), name.c_str(), H5P_DEFAULT) > 0;
    group = {exists ? H5Gopen2(group.id(), name.c_str(), H5P_DEFAULT)
                    : H5Gcreate2(group.id(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
             H5Gclose, action};
  }
  return group;
}

std::vector<std::string> names_in(hid_t group) {
  const auto collect = [](hid_t /*group*/, const char* name, const H5L_info_t* /*link*/, void* list) -> herr_t {
    static_cast<std::vector<std::string>*>(list)->emplace_back(name);
    return 0;
  };
  std::vector<std::string> names;
  check(H5Literate(group, H5_INDEX_NAME, any_order, nullptr, collect, &names), "can't list a group");
  std::ranges::sort(names);
  return names;
}

std::vector<Entry> entries_of(hid_t group) {
  const auto collect = [](hid_t holder, const char* name, const H5L_info_t* /*link*/, void* list) -> herr_t {
    H5O_info_t object;
    if (H5Oget_info_by_name2(holder, name, &object, H5O_INFO_BASIC, H5P_DEFAULT) < 0) {
      return -1;
    }
    static_cast<std::vector<Entry>*>(list)->push_back({name, object.type == H5O_TYPE_GROUP});
    return 0;
  };
  std::vector<Entry> entries;
  check(H5Literate(group, H5_INDEX_NAME, any_order, nullptr, collect, &entries), "can't list a group");
  std::ranges::sort(entries, {}, &Entry::name);
  return entries;
}

std::vector<std::string> datasets_below(hid_t file, const std::string& group) {
  std::vector<std::string> paths;
  if (group != "/" && !exists(file, group)) {
    return paths;
  }
  const auto collect = [](hid_t /*group*/, const char* name, const H5O_info_t* object, void* list) -> herr_t {
    if (object->type == H5O_TYPE_DATASET) {
      static_cast<std::vector<std::string>*>(list)->emplace_back(name);
    }
    return 0;
  };
  check(H5Ovisit_by_name2(file, group.c_str(), H5_INDEX_NAME, any_order, collect, &paths, H5O_INFO_BASIC, H5P_DEFAULT),
        fmt::format("can't list {}", group));
  for (auto& path : paths) {
    path.insert(0, group == "/" ? "/" : group + "/");
  }
  std::ranges::sort(paths);
  return paths;
}

}  // namespace idiophone::store::hdf5
