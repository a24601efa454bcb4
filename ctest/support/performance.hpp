#pragma once
// A stage of sound maps with a score, for tests: what `idiophone play` makes of both.

#include <chrono>

#include "idiophone/instruments/drivers/players.hpp"
#include "idiophone/instruments/voices/sound_map_voices.hpp"
#include "idiophone/instruments/voices/stage.hpp"

namespace idiophone::voices {

/// The maps as the only voice.
inline std::vector<std::unique_ptr<Voice>> voices_of(const std::vector<sound_maps::SoundMap>& maps,
                                                     const Audience& audience, int rate,
                                                     std::span<const score::BodyContact> contacts = {}) {
  std::vector<std::unique_ptr<Voice>> voices;
  voices.push_back(std::make_unique<SoundMapVoices>(shared_maps(maps), audience, rate, MapDetail{}, contacts));
  return voices;
}

inline constexpr int rate = 48000;  ///< of the sound in these tests, 1/s

class Performance {
 public:
  Performance(const std::vector<sound_maps::SoundMap>& maps, const score::Score& score, int audio_rate)
      : audience_(score.listener ? Audience(*score.listener, audio_rate) : audience_of(maps)),
        stage_(audience_, voices_of(maps, audience_, audio_rate, score.contacts), audience_.receivers(), audio_rate),
        notes_(score.notes),
        seed_(score.seed) {
    drivers_.push_back(std::make_unique<drivers::ScoreDriver>(score.events, score.seed, audio_rate));
  }

  [[nodiscard]] Stage& stage() { return stage_; }
  [[nodiscard]] Waits waits() const { return stage_.report().waits; }

  /// The blows of notes; returns how many the score has nothing for.
  std::size_t add(const std::vector<drivers::Note>& notes) {
    const drivers::NoteBlows blows = drivers::blows_of(notes, notes_);
    drivers_.push_back(std::make_unique<drivers::ScoreDriver>(blows.events, 0, stage_.rate()));
    return blows.unknown;
  }

  /// Plays something at once.
  void play(const score::ScoreEvent& event) {
    const std::int64_t sent = std::chrono::steady_clock::now().time_since_epoch().count();
    drivers::Event asked = drivers::event_of(event, stage_.now(), seed_, stage_.rate());
    asked.sent = sent;
    stage_.perform(asked);
  }

  void move_listener(const Vector3& place) {
    stage_.perform({.start = stage_.now(), .action = drivers::ListenerMove{place}});
  }

  void add(std::unique_ptr<drivers::Driver> driver) { drivers_.push_back(std::move(driver)); }

  [[nodiscard]] std::vector<double> rendered(std::int64_t samples, std::int64_t block = 512) {
    return voices::rendered(stage_, drivers_, samples, block);
  }

 private:
  Audience audience_;
  Stage stage_;
  drivers::Drivers drivers_;
  std::vector<score::NoteAction> notes_;
  std::uint64_t seed_;
};

[[nodiscard]] inline std::vector<double> rendered(Performance& performance, std::int64_t samples,
                                                  std::int64_t block = 512) {
  return performance.rendered(samples, block);
}

}  // namespace idiophone::voices
