#pragma once
// How commands that search show their progress and end on a signal.

#include "idiophone/run/loop/progress.hpp"
#include "idiophone/study/fitting/watch.hpp"
#include "shared_options.hpp"

namespace idiophone::app {

/// Progress in eigenvalue problems: one updating line on a terminal, else lines of a log.
[[nodiscard]] inline loop::PieceProgress search_progress(Style style) {
  return {"eigenvalue problems",
          style == Style::text ? loop::progress_style(loop::ProgressWish::automatic, 0) : loop::ProgressStyle::log};
}

/// @param progress  must outlive the watch
[[nodiscard]] inline fitting::Watch watch_by(loop::PieceProgress& progress) {
  return [&progress](const fitting::SearchState& state) {
    return progress.report(state.solves, state.expected, state.best);
  };
}

}  // namespace idiophone::app
