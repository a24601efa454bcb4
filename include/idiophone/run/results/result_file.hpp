#pragma once
// NAME.h5: the results of a run. docs/use/result_file.md describes each dataset.
//
// Every call is collective over the communicator the file was made with; an error on one rank is thrown on all.
// What was appended is on the disk after flush(), which closes the file until the next call: a run that is killed
// between two flushes leaves a file that can be read. No times of day are stored: equal runs give equal contents.

#include <mpi.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

#include "idiophone/files/format.hpp"
#include "idiophone/files/shared_file.hpp"
#include "idiophone/foundation/element/type.hpp"
#include "idiophone/foundation/parallel/archive.hpp"
#include "idiophone/foundation/parallel/rows.hpp"
#include "idiophone/foundation/spectra/series.hpp"

namespace idiophone::results {

/// One body's displacement in a frame.
struct BodyFrame {
  std::string body;
  const parallel::Rows* nodes = nullptr;  ///< its nodes, numbered within the body
  std::span<const double> displacement;   ///< [3 x local rows of `nodes`], m
};

/// Small vibrations of one body. All but the shapes is the same on all ranks.
struct BodyModes {
  std::string body;
  const parallel::Rows* nodes = nullptr;        ///< its nodes, numbered within the body
  std::string mass;                             ///< which mass matrix: "lumped" or "consistent"
  std::int64_t rigid_motions = 0;               ///< number of motions without strain
  std::vector<double> frequencies;              ///< [modes] Hz, ascending
  std::vector<double> damping_ratios;           ///< [modes] zeta
  std::vector<double> decay_times;              ///< [modes] T60, s
  std::vector<double> mesh_errors;              ///< [modes] estimated, cents by which each is too high; may be empty
  std::vector<double> kinetic_shares;           ///< [modes] of the kinetic energy that this body has
  std::vector<std::string> kinds;               ///< [modes] in words, of the assembly; empty texts where there is none
  std::vector<std::span<const double>> shapes;  ///< [modes] of [3 x local rows of `nodes`], m at unit modal mass
};

class ResultFile {
 public:
  /// Prefix of the names in archive().
  static constexpr const char* archive_prefix = "run";

  /// Creates the file; overwrites an existing one.
  /// @throws std::runtime_error if it can't be created (with the system's reason).
  [[nodiscard]] static ResultFile create(const std::filesystem::path& path, const Origin& origin,
                                         MPI_Comm communicator);
  /// Opens the result of a run that is to be resumed.
  /// @throws std::runtime_error if it is not there, damaged, or not a result of this version of the format.
  [[nodiscard]] static ResultFile open(const std::filesystem::path& path, MPI_Comm communicator);

  ResultFile(ResultFile&&) noexcept;
  ResultFile& operator=(ResultFile&&) noexcept;
  ResultFile(const ResultFile&) = delete;
  ResultFile& operator=(const ResultFile&) = delete;
  ~ResultFile();

  /// Adds an empty table. @throws std::runtime_error if the path exists already or the series is not valid
  void declare(const spectra::Series& series);
  /// Appends rows to a declared series.
  /// @param values  on rank 0, [columns x new rows]; ignored elsewhere
  /// @throws std::runtime_error if there is no such series or the last row is incomplete
  void append(const std::string& path, std::span<const double> values);

  /// Adds a body's mesh, and its empty table of frames.
  /// @param reference   [3 x local rows of `nodes`] positions, m
  /// @param cells       for display, see element::DrawnElement
  /// @param cell_nodes  [nodes per cell x local rows of `cells`] node numbers within the body, in VTK's order
  /// @param type        of all elements
  void add_mesh(const std::string& body, const parallel::Rows& nodes, std::span<const double> reference,
                const parallel::Rows& cells, std::span<const std::int32_t> cell_nodes, element::Type type);
  /// Appends a frame: the displacement (single precision) of every body that has a mesh.
  /// @param time  s
  void add_frame(double time, const std::vector<BodyFrame>& bodies);

  /// Adds the modes of a body that has a mesh. The .xdmf then shows modes instead of frames.
  /// @throws std::runtime_error if the numbers of values differ, or the body has no mesh or has modes already
  void add_modes(const BodyModes& modes);

  /// Adds frequencies that the sound is expected to have. The same on all ranks.
  /// @param frequencies  Hz
  void add_reference(const std::string& name, const std::vector<double>& frequencies);

  /// Writes facts into a group, e.g. "/run", which is created if necessary. Numbers and texts become attributes, texts
  /// of several lines and lists of numbers datasets, objects groups.
  /// @param facts  an object, rank 0's; ignored elsewhere
  /// @throws std::runtime_error if one of them exists already
  void note(const std::string& group, const nlohmann::json& facts);
  /// Adds the facts of one more job of the run, /run/jobs/000, /run/jobs/001, ...
  /// @return the group that they were written to
  std::string add_job(const nlohmann::json& facts);

  /// Writes everything to the disk and closes the file; writes NAME.xdmf anew if there are new frames or modes.
  void flush();

  /// Length and checksum of every table. Restoring truncates the tables to their lengths at the checkpoint.
  /// @throws std::runtime_error, and truncates nothing, if a table is shorter than at the checkpoint, or unknown to the
  ///         archive
  void archive(parallel::Archive& archive);

  /// files::Lengths of each series and table of frames.
  [[nodiscard]] files::Lengths lengths();
  /// Truncates every table to its given length.
  /// @throws std::runtime_error, and truncates nothing, if a table is shorter than its length, or not in `lengths`
  void truncate(const files::Lengths& lengths);

 private:
  struct State;
  explicit ResultFile(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace idiophone::results
