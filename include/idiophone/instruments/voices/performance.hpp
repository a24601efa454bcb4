#pragma once
// Bodies that are played: what a score, MIDI and OSC say becomes sound at the listener. Two threads take part. The
// control thread sends commands. The audio thread renders; it never locks, allocates, frees or touches files.

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "idiophone/instruments/drivers/midi.hpp"
#include "idiophone/instruments/outputs/renderer.hpp"
#include "idiophone/instruments/score/score.hpp"
#include "idiophone/instruments/sound_maps/sound_map.hpp"

namespace idiophone::voices {

/// Times from the call of play() to the audio sample at which the blow began. Strokes do not count.
struct Waits {
  std::int64_t count = 0;
  double mean = 0.0;     ///< s
  double longest = 0.0;  ///< s
};

struct Sequencer;

class Performance : public outputs::Renderer {
 public:
  /// @param maps   at least one; with the same listeners if the score has none
  /// @param score  its bodies are indices of maps
  /// @param rate   audio samples per second; modes from half of it on are left out
  /// @throws std::runtime_error when the listeners can't be played, or an event changes a tension
  Performance(std::vector<sound_maps::SoundMap> maps, score::Score score, int rate);
  ~Performance() override;
  Performance(const Performance&) = delete;
  Performance(Performance&&) = delete;
  Performance& operator=(const Performance&) = delete;
  Performance& operator=(Performance&&) = delete;

  [[nodiscard]] const score::Score& score() const;
  [[nodiscard]] int rate() const override;
  [[nodiscard]] std::size_t receivers() const override;
  [[nodiscard]] std::size_t modes() const;

  // The control thread's part.

  /// Adds the blows of MIDI notes to the score; before the first feed().
  /// @return notes that the score has nothing for
  std::size_t add(const std::vector<drivers::Note>& notes);

  /// Sends what the score has before this audio sample. What there is no room for is sent next time.
  void feed(std::int64_t until);

  /// Plays something at once. @throws std::runtime_error when too much is waiting already
  void play(const score::ScoreEvent& event);

  /// Plays a MIDI note at once. Returns false if the score has nothing for it.
  bool play(const drivers::Note& note);

  /// The listener of the score goes to this place; its receivers keep their distances. It goes at no more than a third
  /// of the speed of sound.
  /// @throws std::runtime_error when the score has no listener, moves it itself, or the place is too far away
  void move_listener(const Vector3& position);

  // The audio thread's part.

  /// The next samples, Pa, [frames x receivers]. The bits do not depend on how the samples are divided into blocks, if
  /// commands are sent before their time.
  /// @param clock  ns of the steady clock at the start of the block; to measure delays
  void render(std::span<double> sound, std::int64_t clock = 0) override;

  // Of both.

  /// The audio sample that is rendered next.
  [[nodiscard]] std::int64_t now() const override;

  [[nodiscard]] Waits waits() const;

 private:
  std::unique_ptr<Sequencer> sequencer_;
};

/// The shortest delay of sound from a body to a receiver, audio samples: nearer receivers hear it as late.
[[nodiscard]] double shortest_delay();

/// The next samples of the score, Pa, [samples x receivers].
/// @param block  audio samples that are rendered at once
[[nodiscard]] std::vector<double> rendered(Performance& performance, std::int64_t samples, std::int64_t block = 512);

}  // namespace idiophone::voices
