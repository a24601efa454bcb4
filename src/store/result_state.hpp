#pragma once
// What stands behind a ResultFile.

#include "collective.hpp"
#include "hdf5.hpp"
#include "idiophone/store/result_file.hpp"

namespace idiophone::store {

struct ResultFile::State {
  std::filesystem::path path;
  MPI_Comm communicator = MPI_COMM_NULL;
  hdf5::Handle file;
  bool new_pictures = false;  ///< frames or modes, which the .xdmf does not show yet

  /// The file, opened if it isn't.
  hid_t opened() {
    if (!file.open()) {
      file = hdf5::open_file(path, communicator);
    }
    return file.id();
  }

  hdf5::Handle dataset(const std::string& name) {
    const auto id = opened();
    hdf5::Handle handle;
    collectively(communicator, [&] { handle = hdf5::open_dataset(id, name); });
    return handle;
  }

  /// Appends one body's part of a frame.
  void append_frame(const BodyFrame& frame);
};

}  // namespace idiophone::store
