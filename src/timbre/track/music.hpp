#pragma once
// Background music from motion (Hahn 1995, "Mapping motion parameters to music").

#include <filesystem>
#include <string>
#include <vector>

#include "idiophone/timbre/sonic_scene/sonic_scene.hpp"
#include "idiophone/timbre/track/motion_channels.hpp"

namespace idiophone::timbre {

/// A note of a score.
struct ScoreNote {
  int start = 0;     ///< steps since the beginning
  int length = 1;    ///< steps
  int number = 0;    ///< 60 is c'
  int velocity = 0;  ///< 1 to 127
  int program = 0;   ///< General MIDI instrument, 0 to 127
};

/// The notes of one part, one after another; rests are between them.
struct ScorePart {
  std::string name;
  int tonic = 60;         ///< of the scale
  std::size_t scale = 0;  ///< index into musical_scales()
  std::vector<ScoreNote> notes{};
};

/// The music of a scene.
struct MusicScore {
  std::string title;
  double every = 0.5;     ///< length of a step, s
  double duration = 0.0;  ///< s; the last step may be cut off
  std::vector<ScorePart> parts{};

  /// How many steps begin before the end.
  [[nodiscard]] int steps() const;
};

/// The note of a scale for a value of the motion; values outside of part.from become the nearest end.
[[nodiscard]] int note_of(const MusicPart& part, double value);

/// The music of a scene: the motion is sampled at equal steps. Where a part does not say how long its notes are, equal
/// consecutive notes are one.
/// @param duration  s
/// @throws deck::DeckError for a channel that the motion does not have, and for wrong trees; std::runtime_error for a
/// tree
///         whose numbers are not finite
[[nodiscard]] MusicScore compose(const SonicScene& scene, const MotionChannels& motion, double duration);

/// Writes a standard MIDI file with a track for each part, by libsmf.
/// @throws std::runtime_error if it can't be written
void write_midi(const std::filesystem::path& file, const MusicScore& score);

/// Writes a score as MusicXML 3.1 (W3C Music Notation Community Group, 2017).
/// @throws std::runtime_error if it can't be written
void write_musicxml(const std::filesystem::path& file, const MusicScore& score);

}  // namespace idiophone::timbre
