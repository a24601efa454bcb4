#pragma once
// How commands that do one piece of work after the other show their progress and end on a signal.

#include <string>
#include <vector>

#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/foundation/part_watch.hpp"
#include "idiophone/run/loop/progress.hpp"
#include "idiophone/study/fitting/watch.hpp"
#include "shared_options.hpp"

namespace idiophone::app {

/// One updating line on a terminal, else lines of a log; of rank 0 alone.
/// @param pieces  what is done
[[nodiscard]] inline loop::PieceProgress piece_progress(std::string pieces, Style style, MPI_Comm communicator) {
  const int rank = parallel::rank_of(communicator);
  const auto automatic = loop::progress_style(loop::ProgressWish::automatic, rank);
  return {std::move(pieces), style == Style::text || rank > 0 ? automatic : loop::ProgressStyle::log};
}

/// Progress in eigenvalue problems.
[[nodiscard]] inline loop::PieceProgress search_progress(Style style) {
  return piece_progress("eigenvalue problems", style, MPI_COMM_SELF);
}

/// @param progress  must outlive the watch
[[nodiscard]] inline PartWatch parts_watched_by(loop::PieceProgress& progress) {
  return [&progress](std::size_t done, std::size_t expected) {
    return progress.report(static_cast<int>(done), static_cast<int>(expected), "");
  };
}

/// Work in parts that shows its progress, and what of it a signal left out.
class WatchedWork {
 public:
  /// @param parts  their name, e.g. "modes"
  WatchedWork(const std::string& parts, Style style, MPI_Comm communicator);

  /// The work must outlive the watch.
  [[nodiscard]] PartWatch watch();

  /// Adds what is left out, if anything is, e.g. "8 of 20 modes". Collective.
  void note_left_out(std::vector<std::string>& notes) const;

 private:
  std::string parts_;
  MPI_Comm communicator_;
  loop::PieceProgress progress_;
  std::uint64_t expected_ = 0;
  std::uint64_t left_out_ = 0;
};

/// Whether a signal was noted on any rank. Collective.
[[nodiscard]] bool is_stopped(MPI_Comm communicator);

/// Says on standard error what a signal left out: "8 of 20 modes".
void say_left_out(const std::vector<std::string>& left_out);

/// @param progress  must outlive the watch
[[nodiscard]] inline fitting::Watch watch_by(loop::PieceProgress& progress) {
  return [&progress](const fitting::SearchState& state) {
    return progress.report(state.solves, state.expected, state.best);
  };
}

}  // namespace idiophone::app
