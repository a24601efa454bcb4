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

class MappedSound {
 public:
  /// @param turns          Resonator::turn of each mode
  /// @param channels       1 to most_receivers: the receivers; 2 if the reception has a head
  /// @param longest_delay  audio samples
  MappedSound(std::span<const resonators::Complex> turns, std::size_t channels, const Reception& reception,
              double longest_delay);

  /// Adds what arrives at the receivers or ears to `sound`, [samples x channels]. Realtime-safe.
  /// @param drives  that act in all of these samples
  /// @param sound   at most ResonatorBank::most_samples samples
  void render(std::int64_t first, std::span<const resonators::Drive> drives, std::span<double> sound);

  /// Whether the reception is changing at this audio sample.
  [[nodiscard]] bool is_changing(std::int64_t sample) const { return sample < change_end_; }

  /// Where the present change ends, audio sample.
  [[nodiscard]] std::int64_t change_end() const { return change_end_; }

  /// Begins a change at this audio sample, when none is going on. Realtime-safe.
  void begin(const ReceptionChange& change, std::int64_t sample);

  /// See ResonatorBank. Realtime-safe.
  void retune(std::span<const resonators::ModeGroup> turns) { bank_.retune(turns); }

  /// See ResonatorBank.
  void silence() { bank_.silence(); }

 private:
  void end_change();
  void emit(std::int64_t first, std::size_t samples, std::span<const resonators::Drive> drives);
  /// How much of the change of reception is done at this audio sample, 0 to 1.
  [[nodiscard]] double share(std::int64_t sample) const;

  resonators::ResonatorBank bank_;
  std::size_t channels_;
  std::size_t receivers_;                     // the channels, or the one point where a head is
  std::size_t outputs_;                       // receivers, and zeros up to a power of two
  std::vector<resonators::ModeGroup> gains_;  // [2 outputs x groups] present, then next
  std::vector<double> emitted_;               // [samples x outputs, or 2 outputs]
  std::array<double, most_receivers> delay_{}, next_delay_{};
  std::int64_t change_start_ = 0, change_end_ = 0;
  bool changing_ = false;
  std::vector<Arrivals> arrivals_;  // [receivers]
  std::optional<HeadFilter> head_;
};

}  // namespace idiophone::voices
