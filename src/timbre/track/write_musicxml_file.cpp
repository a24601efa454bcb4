#include <fmt/format.h>

#include <bit>
#include <iterator>

#include <set>
#include <string>
#include <string_view>

#include "idiophone/foundation/markup.hpp"
#include "idiophone/foundation/text_file.hpp"
#include "notation.hpp"

namespace idiophone::timbre {

namespace {

using Text = std::back_insert_iterator<std::string>;

constexpr const char* head = R"(<?xml version="1.0" encoding="UTF-8"?>
<!DOCTYPE score-partwise PUBLIC "-//Recordare//DTD MusicXML 3.1 Partwise//EN" "http://www.musicxml.org/dtds/partwise.dtd">
<score-partwise version="3.1">
)";

std::string_view note_type(int length) {
  switch (std::bit_floor(static_cast<unsigned>(length))) {
    case 32:
      return "whole";
    case 16:
      return "half";
    case 8:
      return "quarter";
    case 4:
      return "eighth";
    case 2:
      return "16th";
    default:
      return "32nd";
  }
}

/// The programs of a part; a part without notes has the first one.
std::set<int> programs_of(const ScorePart& part) {
  std::set<int> programs;
  for (const ScoreNote& note : part.notes) {
    programs.insert(note.program);
  }
  return programs.empty() ? std::set{0} : programs;
}

/// The channel of a part; the tenth one has the drums.
int channel_of(std::size_t part) {
  constexpr std::size_t before_drums = 9;
  return static_cast<int>(part < before_drums ? part + 1 : part + 2);
}

/// The part-list's entry, with an instrument for each program.
void declare_part(Text out, const ScorePart& part, std::size_t number) {
  fmt::format_to(out, "<score-part id=\"P{}\">\n<part-name>{}</part-name>\n", number + 1, in_markup(part.name));
  for (const int program : programs_of(part)) {
    fmt::format_to(
        out, "<score-instrument id=\"P{}-I{}\"><instrument-name>General MIDI {}</instrument-name></score-instrument>\n",
        number + 1, program + 1, program + 1);
  }
  for (const int program : programs_of(part)) {
    fmt::format_to(out,
                   "<midi-instrument id=\"P{0}-I{1}\"><midi-channel>{2}</midi-channel><midi-program>{1}</midi-program>"
                   "</midi-instrument>\n",
                   number + 1, program + 1, channel_of(number));
  }
  fmt::format_to(out, "</score-part>\n");
}

/// What the first measure of a part begins with.
void write_attributes(Text out, const ScorePart& part) {
  double sum = 0.0;
  for (const ScoreNote& note : part.notes) {
    sum += note.number;
  }
  constexpr int middle = 60;
  const bool is_low = !part.notes.empty() && sum < middle * static_cast<double>(part.notes.size());
  fmt::format_to(out,
                 "<attributes><divisions>{}</divisions><key><fifths>{}</fifths></key>"
                 "<time><beats>4</beats><beat-type>4</beat-type></time>"
                 "<clef><sign>{}</sign><line>{}</line></clef></attributes>\n",
                 length_of_quarter, fifths_of(part), is_low ? "F" : "G", is_low ? 4 : 2);
}

void write_tempo(Text out, double quarters_per_minute) {
  fmt::format_to(
      out,
      "<direction placement=\"above\"><direction-type><metronome><beat-unit>quarter</beat-unit>"
      "<per-minute>{0:.6g}</per-minute></metronome></direction-type><sound tempo=\"{0:.6g}\"/></direction>\n",
      quarters_per_minute);
}

void write_pitch(Text out, const Spelling& spelling) {
  fmt::format_to(out, "<pitch><step>{}</step>", spelling.step);
  if (spelling.alter != 0) {
    fmt::format_to(out, "<alter>{}</alter>", spelling.alter);
  }
  fmt::format_to(out, "<octave>{}</octave></pitch>", spelling.octave);
}

/// What a note begins with, up to its length.
void write_note(Text out, const ScoreNote& note, int fifths) {
  constexpr double forte = 0.9;  // of MIDI, one percent of the velocity 90
  fmt::format_to(out, "<note dynamics=\"{:.2f}\">", note.velocity / forte);
  write_pitch(out, spelling_of(note.number, fifths));
}

/// @param program  of a rest, too: MuseScore takes a symbol without instrument as a change
void write_symbol(Text out, const Symbol& symbol, std::size_t part, int program, int fifths) {
  if (symbol.note != nullptr) {
    write_note(out, *symbol.note, fifths);
  } else {
    fmt::format_to(out, "<note><rest{}/>", symbol.length == length_of_measure ? " measure=\"yes\"" : "");
  }
  fmt::format_to(out, "<duration>{}</duration>{}{}<instrument id=\"P{}-I{}\"/><voice>1</voice>", symbol.length,
                 symbol.continues ? "<tie type=\"stop\"/>" : "", symbol.goes_on ? "<tie type=\"start\"/>" : "",
                 part + 1, program + 1);
  fmt::format_to(out, "<type>{}</type>", note_type(symbol.length));
  for (int dot = 1; dot < std::popcount(static_cast<unsigned>(symbol.length)); ++dot) {
    fmt::format_to(out, "<dot/>");
  }
  if (symbol.continues || symbol.goes_on) {
    fmt::format_to(out, "<notations>{}{}</notations>", symbol.continues ? "<tied type=\"stop\"/>" : "",
                   symbol.goes_on ? "<tied type=\"start\"/>" : "");
  }
  fmt::format_to(out, "</note>\n");
}

void write_part(Text out, const MusicScore& score, std::size_t number) {
  const ScorePart& part = score.parts[number];
  const Tempo tempo = tempo_of(score.every);
  const int fifths = fifths_of(part);
  fmt::format_to(out, "<part id=\"P{}\">\n", number + 1);
  int measure = 0, program = *programs_of(part).begin();
  for (const std::vector<Symbol>& symbols : measures_of(part, tempo.step, score.steps())) {
    fmt::format_to(out, "<measure number=\"{}\">\n", ++measure);
    if (measure == 1) {
      write_attributes(out, part);
      if (number == 0) {
        write_tempo(out, tempo.quarters_per_minute);
      }
    }
    for (const Symbol& symbol : symbols) {
      program = symbol.note == nullptr ? program : symbol.note->program;
      write_symbol(out, symbol, number, program, fifths);
    }
    fmt::format_to(out, "</measure>\n");
  }
  fmt::format_to(out, "</part>\n");
}

}  // namespace

void write_musicxml(const std::filesystem::path& file, const MusicScore& score) {
  std::string text = head;
  const Text out(text);
  fmt::format_to(out,
                 "<work><work-title>{}</work-title></work>\n"
                 "<identification><encoding><software>Idiophone</software></encoding></identification>\n<part-list>\n",
                 in_markup(score.title));
  for (std::size_t part = 0; part < score.parts.size(); ++part) {
    declare_part(out, score.parts[part], part);
  }
  text += "</part-list>\n";
  for (std::size_t part = 0; part < score.parts.size(); ++part) {
    write_part(out, score, part);
  }
  write_text(file, text + "</score-partwise>\n");
}

}  // namespace idiophone::timbre
