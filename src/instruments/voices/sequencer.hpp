#pragma once
// The control thread's part of a performance: what the score and the players ask for becomes commands to the player, in
// the order of their times.

#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "audio_commands.hpp"
#include "idiophone/air/receivers/head_responses.hpp"
#include "idiophone/instruments/drivers/midi.hpp"
#include "idiophone/instruments/score/score.hpp"
#include "idiophone/instruments/sound_maps/sound_map.hpp"
#include "instrument.hpp"
#include "player.hpp"

namespace idiophone::voices {

inline constexpr double longest_way = 1.0;  ///< s, of sound from a body to a listener

struct Sequencer {
  score::Score score;
  std::vector<Instrument> instruments;
  std::size_t receivers;
  std::unique_ptr<const receivers::HeadResponses> head;  ///< of the score's listener; or null
  Vector3 shift = Vector3::Zero();  ///< of the listener from where the score has it, m; the player's start needs it
  Player player;
  std::size_t next_event = 0;
  std::int64_t change_end = 0;    ///< audio sample at which the last change of reception is over
  std::deque<Command> queued;     ///< not sent yet
  std::optional<Vector3> wanted;  ///< shift that Performance::move_listener asks for, not queued yet, m

  /// Arguments and errors as for Performance.
  Sequencer(std::vector<sound_maps::SoundMap> maps, score::Score score_to_play, int rate);

  [[nodiscard]] int rate() const { return instruments.front().rate(); }
  void sort_events();
  /// What the score plays for a note, if anything.
  [[nodiscard]] std::optional<score::ScoreEvent> event_of(const drivers::Note& note) const;

  /// Queues that a body has another size or friction from this audio sample on.
  void queue_tuning(std::size_t body, const score::Tuning& tuning, std::int64_t start);
  /// Queues the next pieces of the listener's path, up to an audio sample.
  void queue_path(std::int64_t until);
  /// Queues the move that is wanted, once the last one is over.
  void queue_move();
  /// Queues the events of the score before an audio sample.
  void queue_events(std::int64_t until);
  /// Sends what the player has room for.
  void send_queued();

 private:
  [[nodiscard]] std::vector<Voice> voices() const;
  /// Where it is heard at a time, s. [receivers], or the middle of the head; none without a listener in the score
  [[nodiscard]] std::vector<HearingPoint> points(double time) const;
  /// What is heard of a body there, or by the listeners of its sound map.
  [[nodiscard]] Reception reception(std::size_t body, std::span<const HearingPoint> points) const;
  /// @param start   audio sample
  /// @param length  audio samples, of the transition
  void queue_change(std::size_t body, Reception reception, std::int64_t start, std::int64_t length);
  void queue_changes(std::span<const HearingPoint> points, std::int64_t start, std::int64_t length);
};

}  // namespace idiophone::voices
