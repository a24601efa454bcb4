#include "idiophone/files/hdf5.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <exception>
#include <stdexcept>
#include <system_error>
#include <vector>

#include "idiophone/foundation/parallel/end_job.hpp"
#include "idiophone/foundation/parallel/errors.hpp"

namespace idiophone::hdf5 {

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
  auto access = make_property_list(H5P_FILE_ACCESS);
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

std::string path_of(hid_t file) {
  std::string path(std::max<ssize_t>(H5Fget_name(file, nullptr, 0), 0), ' ');
  H5Fget_name(file, path.data(), path.size() + 1);
  return path;
}

/// Closing is collective. While an error of its own ends a rank, the others may never come, so the end of the process
/// closes the file. After an error that all ranks throw, the file gets what was written so far.
herr_t close_together(hid_t file) {
  const bool is_alone_in_failure = std::uncaught_exceptions() > 0 && !parallel::ranks_fail_together();
  return is_alone_in_failure && parallel::size_of(MPI_COMM_WORLD) > 1 ? 0 : H5Fclose(file);
}

constexpr hsize_t room_for_metadata = 1U << 20U;

/// Opens a file on all ranks.
/// @param open  calls HDF5 with the file access
template <class Open>
Identifier open_together(MPI_Comm communicator, const std::string& action, const Open& open) {
  Identifier file;
  parallel::collectively(communicator, [&] {
    be_quiet();
    const auto access = shared_access(communicator);
    file = {open(access.id()), close_together, action};
  });
  parallel::on_root(communicator, [&] { reserve(file.id(), room_for_metadata); });
  return file;
}

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

Identifier make_property_list(hid_t list_class) {
  return {H5Pcreate(list_class), H5Pclose, "HDF5 property list"};
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

Identifier create_file(const std::filesystem::path& path, MPI_Comm communicator) {
  parallel::on_root(communicator, [&] { try_open(path, O_RDWR | O_CREAT); });
  parallel::collectively(communicator, [&] { try_open(path, O_RDWR); });
  return open_together(communicator, fmt::format("can't create {}", path.string()),
                       [&](hid_t access) { return H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access); });
}

Identifier open_file(const std::filesystem::path& path, MPI_Comm communicator) {
  parallel::collectively(communicator, [&] { try_open(path, O_RDWR); });
  return open_together(communicator, fmt::format("can't open {}", path.string()),
                       [&](hid_t access) { return H5Fopen(path.c_str(), H5F_ACC_RDWR, access); });
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

}  // namespace idiophone::hdf5
