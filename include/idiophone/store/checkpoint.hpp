#pragma once
// A checkpoint is a file that proves itself: all that decides the future of a run, in global numbering, with a checksum
// for each dataset and an end marker written last. Described dataset by dataset in docs/checkpoints.md.
//
// Every call is collective over the communicator given first; an error on one rank is thrown on all.

#include <mpi.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "idiophone/parallel/rows.hpp"

namespace idiophone::store {

/// What a run and a checkpoint must have in common; rank 0's is taken.
struct Identity {
  std::string code_version;            ///< e.g. "0.1.0"
  std::string mesh_hash;               ///< of all bodies' meshes
  std::string deck_text;               ///< verbatim
  std::vector<std::string> overrides;  ///< the --set arguments, verbatim
};

/// When a checkpoint was written, in the run's own count.
struct Moment {
  std::int64_t step = 0;    ///< steps done
  std::int64_t sample = 0;  ///< audio samples done
};

/// Writes checkpoint_<step>.h5 in a directory: as .part first, renamed when it is complete. Dropped without commit(),
/// it leaves nothing behind.
class CheckpointWriter {
 public:
  /// Removes what interrupted writings left in the directory (made if it isn't there), and begins a new file.
  /// @throws std::runtime_error when the directory or file can't be written (with the system's reason).
  CheckpointWriter(const std::filesystem::path& directory, const Identity& identity, const Moment& moment,
                   MPI_Comm communicator);
  CheckpointWriter(CheckpointWriter&&) noexcept;
  CheckpointWriter& operator=(CheckpointWriter&&) noexcept;
  CheckpointWriter(const CheckpointWriter&) = delete;
  CheckpointWriter& operator=(const CheckpointWriter&) = delete;
  ~CheckpointWriter();

  /// Adds a table of distributed rows: [width x local rows] on each rank. Names may have groups ("motion/velocity").
  void add_rows(const std::string& name, const parallel::Rows& rows, int width, std::span<const double> values);
  /// Adds what rank 0 holds; the other ranks' values are ignored.
  void add_root(const std::string& name, std::span<const double> values);
  void add_root(const std::string& name, std::span<const std::int64_t> values);

  /// Seals the file, brings it to the disk under its name, points `latest` to it, and removes all but the newest
  /// `keep` (at least 1) checkpoints, as well as those of later steps: they belong to a run that this one replaces.
  /// @return the checkpoint's path
  /// @throws std::runtime_error when anything can't be written; earlier checkpoints are intact then.
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
  /// @throws std::runtime_error saying what is wrong with it.
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
  /// @throws std::runtime_error when there is no such table or its size or type is another.
  [[nodiscard]] std::vector<double> read_rows(const std::string& name, const parallel::Rows& rows, int width) const;
  /// What rank 0 had, on all ranks.
  [[nodiscard]] std::vector<double> read_root(const std::string& name) const;
  [[nodiscard]] std::vector<std::int64_t> read_integer_root(const std::string& name) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// A file that a resumed run continues.
struct ContinuedFile {
  std::filesystem::path path;
  std::string prefix;  ///< of its tables' names in the checkpoint: ResultFile::archive_prefix, ...
};

/// A checkpoint that can't be resumed from.
struct Refusal {
  std::filesystem::path path;
  std::string reason;
};

/// What a directory offers to a run.
struct CheckpointSearch {
  std::optional<CheckpointReader> checkpoint;  ///< the newest valid one, if there is any
  std::vector<Refusal> refused;                ///< those that were tried before it
  std::vector<std::string> rebuilt;  ///< files that were damaged after it, and are replaced by their sound part
};

/// Looks for a checkpoint to resume from: first where `latest` points, then the others by falling step.
/// A checkpoint is refused when it is damaged or incomplete, or of another code version, mesh, deck or overrides, or
/// when a file to be continued does not begin with what it held when the checkpoint was written. A file that does, but
/// is damaged so that it can't be continued, is replaced by a copy of what it held then.
[[nodiscard]] CheckpointSearch find_checkpoint(const std::filesystem::path& directory, const Identity& identity,
                                               const std::vector<ContinuedFile>& files, MPI_Comm communicator);

}  // namespace idiophone::store
