#pragma once
// What rank 0 tells while a run goes on: one updating line on a terminal, plain lines now and then in a log.

#include <cstdint>

#include <string>

#include "idiophone/parallel/stages.hpp"

namespace idiophone::app {

/// What is to be done, and how its speed is told.
struct Task {
  std::int64_t last_sample = 0;  ///< audio samples in all
  int rate = 44100;              ///< audio samples a second
  int parts = 1;                 ///< of an audio sample, whose speed is told
  std::string parts_name;        ///< e.g. "steps"
};

class Progress {
 public:
  /// @param done    audio samples done before, by the run that is resumed
  /// @param line    whether to update one line, as on a terminal; lines of a log otherwise
  /// @param speaks  whether this rank prints
  Progress(Task task, std::int64_t done, bool line, bool speaks);

  /// At the end of a block.
  /// @param remark  the end of the line
  void tell(std::int64_t done, const std::string& remark);

  /// Since the beginning, s.
  [[nodiscard]] double elapsed() const;

  /// At the end of the work: speed, and each stage's share.
  void conclude(const std::string& speed, const parallel::Stages& stages) const;

 private:
  Task task_;
  std::int64_t resumed_at_;
  bool speaks_;
  bool line_;
  double start_;
  double told_ = -1e9;
};

/// Whether progress shall be one updating line, by the user's wish: "line", "log" or "auto". mpirun gives every rank a
/// terminal of its own making, so under it only the user can know.
[[nodiscard]] bool progress_line(const std::string& wish);

}  // namespace idiophone::app
