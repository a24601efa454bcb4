#pragma once
// A checkpoint is the state of a run in global numbering. A checksum of each dataset and an end marker, written last,
// prove that it is complete. docs/method/checkpoints.md describes each dataset.
//
// Every call is collective over the constructor's communicator; an error on one rank is thrown on all.

#include <mpi.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "idiophone/foundation/parallel/rows.hpp"

namespace idiophone::results {

/// A checkpoint can be resumed by a run of the same identity. Rank 0's is used.
struct Identity {
  std::string code_version;            ///< e.g. "0.1.0"
  std::string mesh_hash;               ///< of all bodies' meshes
  std::string deck_text;               ///< verbatim, and those of a sonic scene and its trees
  std::vector<std::string> overrides;  ///< the --set arguments, verbatim
};

/// The moment of a checkpoint, counted from the beginning of the run.
struct Moment {
  std::int64_t step = 0;    ///< steps done
  std::int64_t sample = 0;  ///< audio samples done
};

/// Writes checkpoint_<step>.h5 in a directory. Until it is complete its name ends in .part. Without commit() nothing
/// remains.
class CheckpointWriter {
 public:
  /// Creates the directory if necessary, removes incomplete files in it, and begins a new one.
  /// @throws std::runtime_error if the directory or file can't be written (with the system's reason).
  CheckpointWriter(const std::filesystem::path& directory, const Identity& identity, const Moment& moment,
                   MPI_Comm communicator);
  CheckpointWriter(CheckpointWriter&&) noexcept;
  CheckpointWriter& operator=(CheckpointWriter&&) noexcept;
  CheckpointWriter(const CheckpointWriter&) = delete;
  CheckpointWriter& operator=(const CheckpointWriter&) = delete;
  ~CheckpointWriter();

  /// Adds a table of distributed rows: [width x local rows] on each rank. Names may have groups ("motion/velocity").
  void add_rows(const std::string& name, const parallel::Rows& rows, int width, std::span<const double> values);
  /// Adds rank 0's values; those of other ranks are ignored.
  void add_root(const std::string& name, std::span<const double> values);
  void add_root(const std::string& name, std::span<const std::int64_t> values);

  /// Writes the end marker and the file's name to the disk, points `latest` to the file, and removes all but the newest
  /// `keep` (at least 1) checkpoints. Checkpoints of later steps are removed, too: they belong to a run that this one
  /// replaces.
  /// @return the checkpoint's path
  /// @throws std::runtime_error if anything can't be written; earlier checkpoints stay intact
  std::filesystem::path commit(int keep);

 private:
  struct State;
  template <class T>
  void write_root_and_sum(const std::string& name, std::span<const T> values);
  std::unique_ptr<State> state_;
};

/// A valid checkpoint, open for reading on every rank, on any number of ranks.
class CheckpointReader {
 public:
  /// Opens one file and checks its end marker and every checksum.
  /// @throws std::runtime_error that says what is wrong with it
  CheckpointReader(const std::filesystem::path& path, MPI_Comm communicator);
  CheckpointReader(CheckpointReader&&) noexcept;
  CheckpointReader& operator=(CheckpointReader&&) noexcept;
  CheckpointReader(const CheckpointReader&) = delete;
  CheckpointReader& operator=(const CheckpointReader&) = delete;
  ~CheckpointReader();

  [[nodiscard]] const std::filesystem::path& path() const;
  [[nodiscard]] const Identity& identity() const;
  [[nodiscard]] const Moment& moment() const;

  /// This rank's rows, [width x local rows].
  /// @throws std::runtime_error if there is no such table or its size or type is another.
  [[nodiscard]] std::vector<double> read_rows(const std::string& name, const parallel::Rows& rows, int width) const;
  /// Rank 0's values, on all ranks.
  [[nodiscard]] std::vector<double> read_root(const std::string& name) const;
  [[nodiscard]] std::vector<std::int64_t> read_integer_root(const std::string& name) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// A file that a resumed run continues.
struct ContinuedFile {
  std::filesystem::path path;
  std::string prefix;  ///< of its tables' names in the checkpoint, e.g. ResultFile::archive_prefix
};

/// A checkpoint that can't be resumed from.
struct Refusal {
  std::filesystem::path path;
  std::string reason;
};

/// The checkpoints of a directory for a run.
struct CheckpointSearch {
  std::optional<CheckpointReader> checkpoint;  ///< the newest valid one, if there is any
  std::vector<Refusal> refused;                ///< those that were tried before
  std::vector<std::string> rebuilt;  ///< files that were damaged after it, and are replaced by their sound part
};

/// Finds a checkpoint to resume from: first the one that `latest` points to, then the others, later steps first. A
/// checkpoint is refused if it is damaged or incomplete, or has another code version, mesh, deck or overrides, or if a
/// file to be continued does not begin with its contents at the checkpoint. A file that does, but is damaged later so
/// that it can't be continued, is replaced by a copy of its contents at the checkpoint.
[[nodiscard]] CheckpointSearch find_checkpoint(const std::filesystem::path& directory, const Identity& identity,
                                               const std::vector<ContinuedFile>& files, MPI_Comm communicator);

}  // namespace idiophone::results
