#pragma once
// HDF5's C interface: identifiers with automatic closing, calls that throw, and files. A file is open either on all
// ranks of a communicator (every call that changes the file's structure is then collective) or on one process,
// read-only.

#include <hdf5.h>
#include <mpi.h>

#include <filesystem>
#include <string>
#include <utility>

namespace idiophone::hdf5 {

/// What H5Oget_info2, H5Oget_info_by_name2 and H5Ovisit2 fill. HDF5 1.12 renamed it.
#if H5_VERSION_GE(1, 12, 0)
using ObjectInfo = H5O_info1_t;
#else
using ObjectInfo = H5O_info_t;
#endif

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

/// The default properties of a class, for example H5P_FILE_ACCESS.
[[nodiscard]] Identifier make_property_list(hid_t list_class);

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

}  // namespace idiophone::hdf5
