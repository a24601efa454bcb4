#pragma once
// A score: what is done to bodies and when. `idiophone play` reads it (docs/use/play.md).

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "idiophone/instruments/score/action.hpp"
#include "idiophone/scene/listeners.hpp"
#include "idiophone/scene/scene.hpp"
#include "idiophone/scene/settings.hpp"

namespace idiophone::score {

/// Something is done to a body.
struct ScoreEvent {
  double time = 0.0;     ///< s
  std::size_t body = 0;  ///< index of the sound map
  std::variant<HammerBlow, MalletBlow, AppliedForce, Stroke, Bow, Tuning, Detail> action;
};

/// What a MIDI note does.
struct NoteAction {
  int note = 0;          ///< 0 to 127; 60 is c'
  std::size_t body = 0;  ///< index of the sound map
  HammerBlow blow;       ///< the hammer's speed belongs to velocity 127 and is less in proportion
  std::optional<Stroke>
      stroke{};              ///< instead of the blow, as long as the key is down; its load belongs to velocity 127
  std::optional<Bow> bow{};  ///< likewise

  [[nodiscard]] bool strikes() const { return !stroke && !bow; }
};

/// A force that follows a motion channel of a result.
struct MotionForce {
  std::string channel;              ///< e.g. "motion/arm/velocity"
  std::string column;               ///< empty for the only column, or for the length of the vector of all columns
  std::size_t body = 0;             ///< index of the sound map
  Vector3 at = Vector3::Zero();     ///< the nearest point of the surface, m
  Vector3 force = Vector3::Zero();  ///< for the value 1 of the channel, N
  double above = 0.0;               ///< value of the channel below which there is no force
};

struct Score {
  std::filesystem::path file;
  double duration = 0.0;                    ///< s
  std::uint64_t seed = 1;                   ///< of roughness
  std::optional<scene::Listener> listener;  ///< instead of those of the sound maps
  std::vector<ScoreEvent> events;
  std::vector<NoteAction> notes;
  std::vector<MotionForce> motion;
  std::vector<BodyContact> contacts;  ///< all the time
  scene::WavFormat wav = scene::WavFormat::float32;
  std::optional<double> wav_full_scale;  ///< pressure that becomes 1.0, Pa; the loudest sample's where not given
};

/// @param bodies  names of the bodies that there are, for the key `body`
/// @throws deck::DeckError with every mistake of the file; std::runtime_error when it can't be read
[[nodiscard]] Score read_score(const std::filesystem::path& file, const std::vector<std::string>& bodies,
                               const std::vector<std::string>& overrides);

/// An event that happens at once, without the key `time`.
/// @param text    YAML, as an item of the score's events
/// @param source  that mistakes are said to be in
/// @throws deck::DeckError with every mistake
[[nodiscard]] ScoreEvent read_event(const std::string& text, const std::string& source,
                                    const std::vector<std::string>& bodies);

/// The scene as a score has it: its duration, and its listener where it has one.
[[nodiscard]] scene::Scene as_scored(scene::Scene scene, const Score& score);

}  // namespace idiophone::score
