#pragma once
// A file that all ranks have open together from its first use to the end of a block, and that grows by rows.

#include "hdf5.hpp"
#include "idiophone/parallel/errors.hpp"
#include "idiophone/store/result_file.hpp"

namespace idiophone::store {

/// Every call is collective; an error on one rank is thrown on all.
struct SharedFile {
  std::filesystem::path path;
  MPI_Comm communicator = MPI_COMM_NULL;
  hdf5::Handle file;

  /// The file, opened if it isn't.
  hid_t opened();
  hdf5::Handle dataset(const std::string& name);

  /// Brings everything to the disk and closes the file.
  /// @return whether it was open
  bool close();

  /// parallel::Rows of each table that can grow.
  Lengths lengths();
  /// Cuts tables back. @throws std::runtime_error, and cuts nothing, unless these are the tables, none of them shorter
  void cut(const Lengths& lengths);
};

}  // namespace idiophone::store
