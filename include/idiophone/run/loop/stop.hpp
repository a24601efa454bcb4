#pragma once
// When and how a command stops before its end. SIGTERM, SIGINT, SIGUSR1 and SIGXCPU (the limit of processor time,
// `ulimit -t`), on any rank, and the deck's wall-clock limit ask for it. While nothing is computed that could be saved,
// a signal ends the process at once with exit_resumable. Later the ranks agree at the end of a block, write a
// checkpoint and leave with the same status.

namespace idiophone::loop {

inline constexpr int exit_finished = 0;
inline constexpr int exit_failed = 1;
inline constexpr int exit_wrong_deck = 2;
inline constexpr int exit_resumable = 75;  ///< EX_TEMPFAIL: stopped in good order, resume me

/// What the four signals do.
enum class OnSignal {
  end,       ///< end the process at once with exit_resumable
  end_wavs,  ///< the same: the result is complete but for its WAV files
  note       ///< be noted; a second one of the same kind, but for SIGXCPU, acts as it would have without us
};

/// From here on, the signals do this. One that was noted and not acted on ends the process now, if that is asked for.
void watch_signals(OnSignal action);

/// From here on, a signal of the launcher, which it sends to all ranks when one of them fails, is reported as such, by
/// rank 0 alone: the rank that failed has said why.
void note_rank(int rank, int ranks);

/// The signal that was noted, or 0.
[[nodiscard]] int noted_signal();

}  // namespace idiophone::loop
