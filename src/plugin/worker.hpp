#pragma once
// What happens outside the audio thread: files of maps are read, stages are made, keys and controls become forces.

#include <array>
#include <atomic>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <string>

#include "controls.hpp"
#include "host_messages.hpp"
#include "idiophone/instruments/drivers/midi.hpp"
#include "played_maps.hpp"

namespace idiophone::plugin {

/// What the audio thread asks for. For a map, the bytes of its path follow.
struct Request {
  enum class Kind {
    load,    ///< a map from a file
    play,    ///< a key
    change,  ///< of controls, if any changed; frees what is done
    tell     ///< the files of all maps
  };
  Kind kind = Kind::change;
  ControlValues values{};
  const PlayedMaps* sounding = nullptr;  ///< what the audio thread renders
  std::int64_t start = 0;  ///< audio sample of `sounding` at which a key's blow begins, or controls change
  drivers::MidiMessage message{};
  std::size_t slot = 0;
  std::uint32_t lost = 0;  ///< requests before that the host had no room for
};

/// The files of maps, by their slots; empty ones have no map.
using MapFiles = std::array<std::string, map_slots>;

class Worker {
 public:
  explicit Worker(int rate);

  /// Audio thread: what is to be rendered from now on. It is kept until a request names a later one.
  [[nodiscard]] PlayedMaps* newest() const { return newest_.load(std::memory_order_acquire); }

  /// Any other thread, as all that follows.
  [[nodiscard]] MapFiles files() const;

  /// @throws std::runtime_error when a map can't be read or played; its slot then has none, and keeps the file's name
  void load(std::size_t slot, const std::string& file, const ControlValues& values);

  /// All at once. @throws as load(), when all others are loaded
  void load_all(const MapFiles& files);

  /// A key or a change of controls. @throws std::runtime_error when it can't be played
  void play(const Request& request);

 private:
  void read(std::size_t slot, const std::string& file);
  void publish();

  int rate_;
  mutable std::mutex mutex_;  // of all below; the audio thread does not touch it
  ControlValues values_ = usual_values();
  MapFiles files_;
  std::array<std::shared_ptr<const sound_maps::SoundMap>, map_slots> maps_{};
  std::deque<std::unique_ptr<PlayedMaps>> played_;  // from the one that sounds to the newest
  std::atomic<PlayedMaps*> newest_{nullptr};
};

}  // namespace idiophone::plugin
