#pragma once
// Sound that one thread computes ahead and the audio thread plays. Neither waits for the other.

#include <array>
#include <atomic>
#include <cstdint>
#include <span>

#include "idiophone/instruments/outputs/ring.hpp"
#include "stage_checks.hpp"

namespace idiophone::engines {

/// What is not ready in time is played later, after a pause. The sound falls to zero at the beginning of a pause and
/// rises after it, within some ms, so that neither clicks.
class ReadySound {
 public:
  /// @param first   audio sample at which it begins
  /// @param frames  that may be ready at once
  ReadySound(std::int64_t first, std::size_t channels, std::size_t frames, int rate);

  // The part of the thread that computes.

  /// Frames that there is room for.
  [[nodiscard]] std::int64_t room() const { return static_cast<std::int64_t>(ring_.room()); }

  /// The next samples, [frames x channels], for which there is room.
  void put(std::span<const double> sound);

  /// Audio samples that all pauses took so far: what is put now is heard so much later.
  [[nodiscard]] std::int64_t delay() const { return delay_.load(std::memory_order_acquire); }

  /// Pauses that cut off a sound, so far.
  [[nodiscard]] std::uint64_t gaps() const { return gaps_.load(std::memory_order_acquire); }

  // The audio thread's part. It takes no lock and no memory.

  /// Adds what is heard from an audio sample on, [frames x channels].
  void take(std::int64_t sample, std::span<double> sound);

 private:
  using Frame = std::array<double, most_channels>;
  void take_next(std::span<double> frame);
  void pause();

  std::size_t channels_;
  double falling_;  // factor for each audio sample
  outputs::Ring<Frame> ring_;
  std::atomic<std::int64_t> delay_{0};
  std::atomic<std::uint64_t> gaps_{0};
  // of the audio thread
  std::int64_t next_;  // audio sample of the next frame
  double gain_ = 1.0;  // of what is ready
  Frame last_{};       // that was heard
  Frame rest_{};       // what is left of a sound that was cut off
};

}  // namespace idiophone::engines
