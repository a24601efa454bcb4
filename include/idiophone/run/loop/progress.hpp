#pragma once
// What rank 0 reports while a run goes on: one updating line on a terminal, plain lines now and then in a log.

#include <cstdint>
#include <ctime>
#include <string>

#include "idiophone/foundation/parallel/stages.hpp"

namespace idiophone::loop {

/// What is to be done, and the unit of its speed.
struct Task {
  std::int64_t samples = 0;  ///< audio samples in all
  int rate = 44100;          ///< audio samples a second
  int parts = 1;             ///< of an audio sample, whose speed is reported
  std::string parts_name;    ///< e.g. "steps"
};

/// How progress is printed.
enum class ProgressStyle {
  line,   ///< one line, updated
  log,    ///< a line now and then
  silent  ///< not at all: the ranks other than 0
};

class Progress {
 public:
  /// Its clock begins to run.
  /// @param done  audio samples done before, by the run that is resumed
  Progress(Task task, std::int64_t done, ProgressStyle style);

  /// At the end of a block.
  /// @param remark  the end of the line
  void report(std::int64_t done, const std::string& remark);

  /// Since the beginning, s.
  [[nodiscard]] double elapsed() const;

  /// Processor time of this rank since the beginning, s.
  [[nodiscard]] double processor_time() const;

  /// At the end of the work: speed, and each stage's share.
  void conclude(const std::string& speed, const parallel::Stages& stages) const;

 private:
  Task task_;
  std::int64_t resumed_at_;
  ProgressStyle style_;
  double start_;
  std::clock_t start_of_processor_;
  double reported_ = -1e9;
};

/// Progress of a command that does one piece of work after the other, and how a signal ends it.
class PieceProgress {
 public:
  /// Its clock begins to run.
  /// @param pieces  what is done, e.g. "eigenvalue problems"
  PieceProgress(std::string pieces, ProgressStyle style);
  PieceProgress(const PieceProgress&) = delete;
  PieceProgress& operator=(const PieceProgress&) = delete;
  PieceProgress(PieceProgress&&) = delete;
  PieceProgress& operator=(PieceProgress&&) = delete;
  ~PieceProgress();  ///< ends the line that was updated

  /// After a piece of work. From the first one on, there is something to save, and signals are noted.
  /// @param expected  pieces in all, as far as can be said now
  /// @param remark    the end of the line, e.g. the best values so far
  /// @return whether to go on: no signal was noted
  [[nodiscard]] bool report(int done, int expected, const std::string& remark);

 private:
  std::string pieces_;
  ProgressStyle style_;
  double start_;
  double reported_;
  bool has_open_line_ = false;
};

/// What the user wishes. mpirun gives every rank a terminal of its own making, so under it only the user can know.
enum class ProgressWish {
  automatic,  ///< a line where standard output is a terminal and there is one rank, else a log
  line,
  log
};

/// Ranks other than 0 are silent.
[[nodiscard]] ProgressStyle progress_style(ProgressWish wish, int rank);

}  // namespace idiophone::loop
