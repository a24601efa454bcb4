#include "notation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

namespace idiophone::timbre {

namespace {

/// The longest symbol that is not longer than this.
int longest_symbol(int length) {
  constexpr std::array lengths = {32, 28, 24, 16, 14, 12, 8, 7, 6, 4, 3, 2, 1};
  return *std::ranges::find_if(lengths, [length](int candidate) { return candidate <= length; });
}

/// Appends a note or a rest, cut at the bars.
void append(std::vector<std::vector<Symbol>>& measures, const ScoreNote* note, int begin, int end) {
  for (int at = begin; at < end;) {
    const int room = length_of_measure - at % length_of_measure;
    const int length = longest_symbol(std::min(end - at, room));
    const bool is_note = note != nullptr;
    measures[at / length_of_measure].push_back(
        {.note = note, .length = length, .continues = is_note && at > begin, .goes_on = is_note && at + length < end});
    at += length;
  }
}

}  // namespace

Tempo tempo_of(double every) {
  constexpr double usual = 120.0;
  Tempo nearest;
  double least = std::numeric_limits<double>::infinity();
  for (int step = 1; step <= length_of_measure; step *= 2) {
    const double tempo = 60.0 / every * step / length_of_quarter;
    const double distance = std::abs(std::log(tempo / usual));
    if (distance < least) {
      least = distance;
      nearest = {.step = step, .quarters_per_minute = tempo};
    }
  }
  return nearest;
}

std::vector<std::vector<Symbol>> measures_of(const ScorePart& part, int step, int steps) {
  const int count = std::max(1, (steps * step + length_of_measure - 1) / length_of_measure);
  std::vector<std::vector<Symbol>> measures(count);
  int written = 0;
  for (const ScoreNote& note : part.notes) {
    const int begin = note.start * step, end = (note.start + note.length) * step;
    append(measures, nullptr, written, begin);
    append(measures, &note, begin, end);
    written = end;
  }
  append(measures, nullptr, written, count * length_of_measure);
  return measures;
}

int fifths_of(const ScorePart& part) {
  // How far the scale is from ionian on the same tonic, in fifths.
  static constexpr std::array<std::pair<std::string_view, int>, 9> modes = {{{"ionian", 0},
                                                                             {"dorian", -2},
                                                                             {"phrygian", -4},
                                                                             {"lydian", 1},
                                                                             {"mixolydian", -1},
                                                                             {"aeolian", -3},
                                                                             {"locrian", -5},
                                                                             {"pentatonic", 0},
                                                                             {"blues", -3}}};
  const std::string& scale = musical_scales()[part.scale].first;
  const auto* mode = std::ranges::find(modes, scale, &std::pair<std::string_view, int>::first);
  if (mode == modes.end()) {
    return 0;
  }
  constexpr int most_flats = 5, semitones = 12, fifth = 7;
  const int fifths = fifth * part.tonic + mode->second;
  return ((fifths + most_flats) % semitones + semitones) % semitones - most_flats;
}

Spelling spelling_of(int number, int fifths) {
  constexpr int semitones = 12, fifth = 7;
  const int lowest = fifths - 3;  // place on the line of fifths; C is 0, and F, before it, -1
  const int place = lowest + ((fifth * number - lowest) % semitones + semitones) % semitones;
  static constexpr std::string_view letters = "FCGDAEB";
  static constexpr std::array naturals = {5, 0, 7, 2, 9, 4, 11};
  const int letter = ((place + 1) % 7 + 7) % 7;
  const int alter = (place + 1 - letter) / 7;
  return {.step = letters[letter], .alter = alter, .octave = (number - naturals[letter] - alter) / semitones - 1};
}

}  // namespace idiophone::timbre
