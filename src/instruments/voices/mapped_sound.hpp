#pragma once
// One body in the audio thread: its modes, the forces that act on it, and its sound on the way to the receivers.

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "audio_commands.hpp"
#include "idiophone/instruments/voices/arrivals.hpp"
#include "idiophone/instruments/voices/head_filter.hpp"

namespace idiophone::voices {

/// What leaves a body in an audio sample for a receiver.
struct Emitted {
  double pressure = 0.0;  ///< as it is heard there, Pa
  double delay = 0.0;     ///< audio samples
};

class MappedSound {
 public:
  /// @param channels  1 to most_receivers: the receivers; 2 if the reception has a head
  MappedSound(resonators::ResonatorBank bank, std::size_t channels, const Reception& reception, int rate);

  /// Begins a piece of at most ResonatorBank::most_samples samples.
  void begin_piece();

  /// The next samples of the piece, while no contacts act. With a head, adds what arrives at the ears to `sound`,
  /// [samples x channels]. Without, what leaves the body is emitted(). Realtime-safe.
  /// @param drives    that act in all of these samples
  /// @param contacts  none
  void render(std::int64_t first, std::span<const resonators::Drive> drives, resonators::PointContacts& contacts,
              std::span<double> sound);

  /// The same while contacts act: advance_together() comes between the two. Realtime-safe.
  [[nodiscard]] resonators::BodyInContact begin_contact(std::int64_t first, std::span<const resonators::Drive> drives,
                                                        std::size_t samples);
  void end_contact(std::int64_t first, std::span<double> sound);

  /// Whether anything was emitted in the piece.
  [[nodiscard]] bool emits() const { return emits_; }

  /// In a sample of the piece, for a receiver, if it emits().
  [[nodiscard]] const Emitted& emitted(std::size_t sample, std::size_t receiver) const {
    return emitted_[sample * receivers_ + receiver];
  }

  /// Whether nothing would change if it is not rendered.
  [[nodiscard]] bool is_silent() const { return !head_ && !changing_ && !bank_.sounds(); }

  /// Whether the reception is changing at this audio sample.
  [[nodiscard]] bool is_changing(std::int64_t sample) const { return sample < change_end_; }

  /// Where the present change ends, audio sample.
  [[nodiscard]] std::int64_t change_end() const { return change_end_; }

  /// Whether a change for good has begun, or is over.
  [[nodiscard]] bool leaves() const { return leaves_; }
  [[nodiscard]] bool has_left() const { return leaves_ && !changing_; }

  /// Begins a change at this audio sample. Without a head, another one may be going on: it stops where it is.
  /// Realtime-safe.
  void begin(const ReceptionChange& change, std::int64_t sample);

  /// See ResonatorBank. Realtime-safe.
  void retune(std::span<const resonators::ModeGroup> turns, double size);

  /// See ResonatorBank.
  [[nodiscard]] bool hears(std::size_t group) const { return bank_.hears(group); }

  /// Whether it moves, heard or not.
  [[nodiscard]] bool sounds() const { return bank_.sounds(); }

  /// See ResonatorBank.
  [[nodiscard]] bool stretches() const { return bank_.stretches({}); }
  [[nodiscard]] std::size_t stretching_operations() const { return bank_.stretching_operations(); }

  [[nodiscard]] double largest_rotation() const { return bank_.largest_rotation(); }

  [[nodiscard]] std::size_t groups() const { return bank_.groups(); }

  /// Mean square of the pressure of each mode where the listener is, the mean of its receivers. Realtime-safe.
  /// @param power  [groups x modes in a group] Pa^2
  void measure(std::span<double> power);

  /// Of MaskingThreshold.
  [[nodiscard]] std::size_t bin_of(std::size_t mode) const { return bins_[mode]; }

  /// See ResonatorBank. Realtime-safe.
  void choose(std::span<const char> heard, std::size_t fade) { bank_.choose(heard, fade); }

  /// Where the listener is, or goes.
  [[nodiscard]] const ListenerFromBody& listener() const { return listener_; }

  /// See ResonatorBank.
  void silence() { bank_.silence(); }

 private:
  void end_change();
  void stop_change(double share);
  void find_bins();
  [[nodiscard]] std::size_t present_outputs() const { return changing_ ? 2 * outputs_ : outputs_; }
  void emit(std::int64_t first, std::size_t samples);
  void finish(std::int64_t first, std::span<double> sound);
  void hear(std::int64_t first, std::span<const Emitted> emitted, std::span<double> sound);
  /// How much of the change of reception is done at this audio sample, 0 to 1.
  [[nodiscard]] double share(std::int64_t sample) const;

  resonators::ResonatorBank bank_;
  int rate_;
  std::vector<std::size_t> bins_;  // [groups x modes in a group]
  ListenerFromBody listener_;
  std::size_t channels_;
  std::size_t receivers_;                     // the channels, or the one point where a head is
  std::size_t outputs_;                       // receivers, and zeros up to a power of two
  std::vector<resonators::ModeGroup> gains_;  // [2 outputs x groups] present, then next
  std::vector<double> outputs_of_modes_;      // [samples x outputs, or 2 outputs]
  std::vector<Emitted> emitted_;              // [samples x receivers] of the piece
  std::size_t done_ = 0;                      // samples of the piece
  bool emits_ = false;
  std::array<double, most_receivers> delay_{}, next_delay_{};
  std::int64_t change_start_ = 0, change_end_ = 0;
  bool changing_ = false;
  bool leaves_ = false;
  std::optional<Arrivals> arrivals_;  // at the middle of the head
  std::optional<HeadFilter> head_;
};

}  // namespace idiophone::voices
