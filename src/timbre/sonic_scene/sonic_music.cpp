#include "sonic_music.hpp"

#include "sonic_variables.hpp"

namespace idiophone::timbre {

using namespace deck;  // values, keys and sections

namespace {

Choices<std::size_t> names_of_scales() {
  Choices<std::size_t> names;
  for (std::size_t scale = 0; scale < musical_scales().size(); ++scale) {
    names.words.emplace_back(musical_scales()[scale].first, scale);
  }
  return names;
}

/// Of a part; a type of this namespace, so that Section finds the functions here.
struct PartRules : MusicRules {};

/// Music is no contact, so it has no event.
bool refuse_event(const Node& node, Mistakes& mistakes, const Variable& variable) {
  return !std::holds_alternative<EventVariable>(variable) ||
         mistakes.add(node, "is bound to an event, but no contact starts the music");
}

/// The keys class and parameters.
bool read_tree_variable(Section& section, TreeVariable& tree, const PartRules& rules) {
  bool good = section.required("class", tree.sound_class, rules.classes);
  if (const Node* parameters = section.find("parameters")) {
    good &= section.required("parameters", tree.parameters, rules.variables);
    for (const NamedVariable& parameter : tree.parameters) {
      good &= refuse_event(*parameters, section.mistakes(), parameter.variable);
    }
  }
  return good;
}

/// A constant within `allowed`, or what changes over time: {keys}, {channel}, {class}, or the name of a variable.
bool read(const Node& node, Mistakes& mistakes, MusicVariable& variable, const PartRules& rules, const Range& allowed) {
  if (node.kind == Node::Kind::map) {
    Section section(node, mistakes);
    if (section.find("class") != nullptr) {
      const bool good = read_tree_variable(section, variable.emplace<TreeVariable>(), rules);
      return section.finish() && good;
    }
  }
  NamedVariable named;
  if (!read(node, mistakes, named, rules.variables) || !refuse_event(node, mistakes, named.variable)) {
    return false;
  }
  if (auto* number = std::get_if<double>(&named.variable)) {
    variable = *number;
    return allowed.contains(*number) || read(node, mistakes, *number, allowed);
  }
  if (auto* keyframes = std::get_if<Keyframes>(&named.variable)) {
    variable = std::move(*keyframes);
  } else {
    variable = std::get<MotionVariable>(std::move(named.variable));
  }
  return true;
}

/// A part has its pitch in its own keys: channel, column and interpolation, or class and parameters.
void read_pitch(Section& section, MusicPart& part, const PartRules& rules) {
  if (section.find("class") == nullptr) {
    section.refuse("parameters", "has no meaning without class");
    read_channel(section, part.pitch.emplace<MotionVariable>());
    return;
  }
  for (const char* key : {"channel", "column", "interpolation"}) {
    section.refuse(key, "has no meaning with class; bind its parameters to channels");
  }
  read_tree_variable(section, part.pitch.emplace<TreeVariable>(), rules);
}

void read_variable(Section& section, const std::string& key, MusicVariable& variable, const PartRules& rules,
                   const Range& allowed) {
  if (section.find(key) != nullptr) {
    section.required(key, variable, rules, allowed);
  }
}

bool read(const Node& node, Mistakes& mistakes, Rests& rests, const PartRules& rules) {
  Section section(node, mistakes);
  section.required("value", rests.value, rules, Range{});
  section.required("below", rests.below, Range{});
  return section.finish();
}

bool read(const Node& node, Mistakes& mistakes, MusicPart& part, const PartRules& rules) {
  constexpr Range midi_number{.at_least = 0.0, .at_most = 127.0};
  Section section(node, mistakes);
  read_pitch(section, part, rules);
  if (section.required("from", part.from, NumberPair{}) && part.from[0] == part.from[1]) {
    mistakes.add(*section.find("from"), "the two numbers are the same");
  }
  section.required("scale", part.scale, names_of_scales());
  section.optional("tonic", part.tonic, midi_number);
  section.optional("octaves", part.octaves, Range{.at_least = 1.0, .at_most = 10.0});
  if (part.tonic + 12 * part.octaves > 127) {
    mistakes.add(node, "the highest note is above 127; lower tonic or octaves");
  }
  read_variable(section, "program", part.program, rules, midi_number);
  read_variable(section, "velocity", part.velocity, rules, Range{.at_least = 1.0, .at_most = 127.0});
  if (section.find("steps") != nullptr) {
    read_variable(section, "steps", part.steps.emplace(), rules, Range{.at_least = 1.0, .at_most = longest_note});
  }
  if (section.find("rest") != nullptr) {
    section.required("rest", part.rests.emplace(), rules);
  }
  return section.finish();
}

}  // namespace

bool read(const Node& node, Mistakes& mistakes, Music& music, const MusicRules& rules) {
  Section section(node, mistakes);
  section.optional("every", music.every, Range{.at_least = 0.01, .at_most = 60.0, .unit = "s"});
  section.required("parts", music.parts, PartRules{rules});
  if (music.parts.size() > 15) {
    mistakes.add(node, "MIDI has channels for 15 parts");
  }
  return section.finish();
}

const std::vector<std::pair<std::string, std::vector<int>>>& musical_scales() {
  static const std::vector<std::pair<std::string, std::vector<int>>> scales = {
      {"ionian", {0, 2, 4, 5, 7, 9, 11}},     {"dorian", {0, 2, 3, 5, 7, 9, 10}},
      {"phrygian", {0, 1, 3, 5, 7, 8, 10}},   {"lydian", {0, 2, 4, 6, 7, 9, 11}},
      {"mixolydian", {0, 2, 4, 5, 7, 9, 10}}, {"aeolian", {0, 2, 3, 5, 7, 8, 10}},
      {"locrian", {0, 1, 3, 5, 6, 8, 10}},    {"pentatonic", {0, 2, 4, 7, 9}},
      {"blues", {0, 3, 5, 6, 7, 10}},         {"chromatic", {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}}};
  return scales;
}

}  // namespace idiophone::timbre
