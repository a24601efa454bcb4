#pragma once
// When and how a run stops before its end. SIGTERM, SIGINT and SIGUSR1, on any rank, and the deck's wall-clock limit
// ask for it; the ranks agree at the end of a block, write a checkpoint and leave with exit_resumable. A second signal
// of the same kind acts at once, as it would have without us.

namespace idiophone::app {

inline constexpr int exit_finished = 0;
inline constexpr int exit_failed = 1;
inline constexpr int exit_wrong_deck = 2;
inline constexpr int exit_resumable = 75;  ///< EX_TEMPFAIL: stopped in good order, resume me

/// Begins to note the three signals.
void watch_signals();

/// The signal that was noted, or 0.
[[nodiscard]] int noted_signal();

}  // namespace idiophone::app
