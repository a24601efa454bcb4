#pragma once
// Sound maps under the keys of a keyboard: a stage of voices, and what keys and controls do to it. The control thread
// asks, the audio thread renders the stage.

#include <cstdint>
#include <memory>
#include <vector>

#include "controls.hpp"
#include "idiophone/instruments/drivers/midi_actions.hpp"
#include "idiophone/instruments/sound_maps/sound_map.hpp"
#include "idiophone/instruments/voices/stage.hpp"

namespace idiophone::plugin {

using Maps = std::vector<std::shared_ptr<const sound_maps::SoundMap>>;

/// The driver of a stage whose events somebody else adds.
class HostDriver : public drivers::Driver {
 public:
  void ask(std::int64_t now, std::int64_t until, std::vector<drivers::Event>& events) override;

  std::vector<drivers::Event> waiting;  ///< to be asked for next
};

class PlayedMaps {
 public:
  static constexpr std::size_t channels = 2;
  static constexpr int lowest_key = 21, highest_key = 108;  ///< of tuned and scaled bodies: the keys of a piano

  /// @param maps  none: silence
  /// @param rate  audio samples per second
  PlayedMaps(Maps maps, const Controls& controls, int rate);

  [[nodiscard]] Keyboard keyboard() const { return controls_.keyboard; }

  /// Channels: left and right. Its render() is for the audio thread.
  [[nodiscard]] voices::Stage& stage() { return *stage_; }

  // The control thread's part.

  /// @param controls  with the same keyboard
  /// @param start     audio sample from which on they hold
  void change(const Controls& controls, std::int64_t start);

  /// @param start  audio sample at which a blow begins
  /// @throws std::runtime_error when too many forces go on
  void take(const drivers::MidiMessage& message, std::int64_t start);

  /// Called often: does what waits, and frees what is done.
  void attend();

 private:
  [[nodiscard]] const sound_maps::SoundMap& map_of(std::size_t body) const;
  [[nodiscard]] Vector3 listener() const;
  void tune_all(std::int64_t start);
  void set_keys();

  Maps maps_;
  Controls controls_;
  std::vector<int> keys_;  // [bodies] of tuned and scaled bodies
  std::unique_ptr<voices::Stage> stage_;
  HostDriver* host_;          // of drivers_
  drivers::Drivers drivers_;  // one
  drivers::MidiActions actions_;
};

}  // namespace idiophone::plugin
