#pragma once
// Wanted frequencies, as a user writes them: "187,748", "F#3,A4", "1:4:10".

#include <optional>
#include <string>
#include <vector>

namespace idiophone::fitting {

inline constexpr double concert_pitch = 440.0;  ///< of A4, Hz

/// Frequency of a note in equal temperament, Hz: a letter, # or b, an octave; A4 is a', C4 is c'.
/// @param a4  frequency of A4, Hz
/// @throws std::runtime_error for any other text
[[nodiscard]] double note_frequency(const std::string& note, double a4 = concert_pitch);

/// What modes shall be tuned to.
struct Target {
  std::vector<double> values;  ///< at least one, above 0; Hz, or ratios of the frequencies
  bool are_ratios = false;     ///< any common factor of the frequencies will do
};

/// @param text   frequencies and notes separated by commas, or ratios separated by colons
/// @param pitch  note or Hz that the first of the ratios shall have, if any
/// @throws std::runtime_error for any other text, or a pitch without ratios
[[nodiscard]] Target read_target(const std::string& text, const std::optional<std::string>& pitch, double a4);

/// A decay time that a mode shall have.
struct WantedDecay {
  int mode = 0;             ///< its number at the start, from 1 on
  double decay_time = 0.0;  ///< T60, s
};

/// @param text  MODE=SECONDS
/// @throws std::runtime_error for any other text
[[nodiscard]] WantedDecay read_wanted_decay(const std::string& text);

/// How loud the blows of the deck shall be at a listener.
struct WantedLevel {
  enum class Kind { equal, at_least, at_most };
  std::string listener;  ///< name of the channel: "ear", "ears.left"
  Kind kind = Kind::equal;
  double level = 0.0;  ///< A-weighted sound exposure level (LAE), dB re 20 uPa
};

/// @param text  LISTENER=DB, LISTENER=at_least:DB or LISTENER=at_most:DB
/// @throws std::runtime_error for any other text
[[nodiscard]] WantedLevel read_wanted_level(const std::string& text);

/// Frequencies that no mode shall have, Hz.
struct Band {
  double lower = 0.0;
  double upper = 0.0;
};

/// @param text  LOWEST:HIGHEST, in Hz or notes, or a frequency or note and a distance from it in cents: A4~50
/// @throws std::runtime_error for any other text
[[nodiscard]] Band read_band(const std::string& text, double a4);

}  // namespace idiophone::fitting
