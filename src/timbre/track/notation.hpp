#pragma once
// How a score is written on staves: measures, lengths of notes with ties over bars, keys, and names of notes.

#include <vector>

#include "music.hpp"

namespace idiophone::timbre {

/// The unit of lengths is a thirty-second note; a measure of four quarters has 32 of them.
inline constexpr int length_of_measure = 32, length_of_quarter = 8;

/// One symbol: a note or a rest.
struct Symbol {
  const ScoreNote* note = nullptr;  ///< null for a rest
  int length = 0;                   ///< a power of two, with up to two dots
  bool continues = false;           ///< a tie leads to it
  bool goes_on = false;             ///< a tie leads from it to the next
};

/// How steps become note values: the one nearest to 120 quarters a minute.
struct Tempo {
  int step = length_of_quarter;  ///< length of a step: 1 to 32, a power of two
  double quarters_per_minute = 120.0;
};

[[nodiscard]] Tempo tempo_of(double every);

/// The measures of a part, each completely filled. @param steps  of the whole score
[[nodiscard]] std::vector<std::vector<Symbol>> measures_of(const ScorePart& part, int step, int steps);

/// The key signature of a scale: sharps, or flats if negative; -5 to 6. Pentatonic is taken as ionian, blues as
/// aeolian; chromatic has none.
[[nodiscard]] int fifths_of(const ScorePart& part);

/// A note's name.
struct Spelling {
  char step = 'C';
  int alter = 0;   ///< 1 is a sharp, -1 a flat
  int octave = 4;  ///< of c'
};

/// The name of a note on the line of fifths, from three fifths below the key's tonic to eight above it.
[[nodiscard]] Spelling spelling_of(int number, int fifths);

}  // namespace idiophone::timbre
