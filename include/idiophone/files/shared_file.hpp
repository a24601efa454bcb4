#pragma once
// A file that grows by rows. All ranks have it open together from its first use in a block to the end of the block.

#include "idiophone/files/hdf5.hpp"
#include "idiophone/foundation/parallel/archive.hpp"
#include "idiophone/foundation/parallel/errors.hpp"

namespace idiophone::files {

/// Rows in each table that can grow, by its path.
using Lengths = std::map<std::string, std::int64_t>;

/// Every call is collective; an error on one rank is thrown on all.
struct SharedFile {
  std::filesystem::path path;
  MPI_Comm communicator = MPI_COMM_NULL;
  hdf5::Identifier file;
  int uses = 0;  ///< of the file since its last flush

  /// The file, opened if it isn't.
  hid_t opened();
  hdf5::Identifier dataset(const std::string& name);

  /// Writes everything to the disk and closes the file.
  /// @return whether it was open
  bool close();

  /// Extends the checksums of a table (table_checksums.hpp) by the rows that were just appended.
  /// @param first_row  the first of them
  /// @param rows       rank 0's: the checksum of each
  void add_checksums(const std::string& name, const hdf5::Identifier& table, std::int64_t first_row,
                     const std::vector<std::uint32_t>& rows);

  /// Rows of each table that can grow.
  Lengths lengths();
  /// Truncates tables. @throws std::runtime_error, and truncates nothing, unless these are the tables, none of them
  /// shorter
  void truncate(const Lengths& lengths);

  /// State in a checkpoint: length and digest of the checksums of each table. Restoring truncates the tables to these
  /// lengths; require_as_saved() (verification.hpp) compares their values before.
  /// @param prefix  of the names in the archive
  void archive(parallel::Archive& archive, const std::string& prefix);

 private:
  void cut_table(const std::string& name, std::int64_t rows);
  void write_changes();
};

}  // namespace idiophone::files
