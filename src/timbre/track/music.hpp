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
  double start = 0.0;     ///< s
  double duration = 0.0;  ///< s
  int number = 0;         ///< 60 is c'
  int velocity = 0;       ///< 1 to 127
};

/// The notes of one instrument.
struct ScorePart {
  std::string name;
  int program = 0;  ///< General MIDI instrument, 0 to 127
  std::vector<ScoreNote> notes;
};

/// The note of a scale for a value of the motion; values outside of part.from become the nearest end.
[[nodiscard]] int note_of(const timbre::MusicPart& part, double value);

/// The parts of the music: the channels are sampled at equal steps, and equal consecutive notes are one.
/// @throws deck::DeckError for a channel that the motion does not have
[[nodiscard]] std::vector<ScorePart> compose(const timbre::Music& music, const MotionChannels& motion, double duration);

/// Writes a standard MIDI file with a track for each part, by libsmf.
/// @throws std::runtime_error if it can't be written
void write_midi(const std::filesystem::path& file, const std::vector<ScorePart>& parts);

}  // namespace idiophone::timbre
