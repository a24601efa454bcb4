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

/// In place of a signal's number: the host of a guest asks for a stop.
inline constexpr int asked_by_host = 1000;

/// The signal that was noted, or asked_by_host, or 0.
[[nodiscard]] int noted_signal();

/// While it lives, computations are guests in the process of another program, for example Python: signals never end the
/// process, but are noted from the beginning on, whatever watch_signals() is asked for. One at a time.
class GuestSignals {
 public:
  GuestSignals();
  GuestSignals(const GuestSignals&) = delete;
  GuestSignals& operator=(const GuestSignals&) = delete;
  GuestSignals(GuestSignals&&) = delete;
  GuestSignals& operator=(GuestSignals&&) = delete;
  /// The host has its handlers again, and gets the signal that was noted and that nobody took.
  ~GuestSignals();

  /// The host asks for a stop, as a signal would.
  static void ask_to_stop();

  /// As noted_signal(). Who takes it has acted on it.
  [[nodiscard]] static int take();
};

}  // namespace idiophone::loop
