#include "sonic_music.hpp"

#include "sonic_variables.hpp"

namespace idiophone::timbre {

using namespace deck;  // values, keys and sections

namespace {

void read_velocity(Section& section, MusicPart& part) {
  const Range velocities{.at_least = 1.0, .at_most = 127.0};
  const Node* node = section.find("velocity");
  if (node != nullptr && node->kind == Node::Kind::map) {
    Section channel(*node, section.mistakes());
    auto& motion = part.velocity.emplace<MotionVariable>();
    read_channel(channel, motion);
    read_mapping(channel, motion.mapping);
    channel.finish();
  } else {
    section.optional("velocity", std::get<int>(part.velocity), velocities);
  }
}

struct PartRules {
  Choices<std::size_t> scales;
};

bool read(const Node& node, Mistakes& mistakes, MusicPart& part, const PartRules& rules) {
  Section section(node, mistakes);
  read_channel(section, part.pitch);
  if (section.required("from", part.from, NumberPair{}) && part.from[0] == part.from[1]) {
    mistakes.add(*section.find("from"), "the two numbers are the same");
  }
  section.required("scale", part.scale, rules.scales);
  section.optional("tonic", part.tonic, Range{.at_least = 0.0, .at_most = 127.0});
  section.optional("octaves", part.octaves, Range{.at_least = 1.0, .at_most = 10.0});
  section.optional("program", part.program, Range{.at_least = 0.0, .at_most = 127.0});
  if (part.tonic + 12 * part.octaves > 127) {
    mistakes.add(node, "the highest note is above 127; lower tonic or octaves");
  }
  read_velocity(section, part);
  return section.finish();
}

}  // namespace

bool read(const Node& node, Mistakes& mistakes, Music& music, const MusicKeys& /*rule*/) {
  PartRules rules;
  for (std::size_t i = 0; i < musical_scales().size(); ++i) {
    rules.scales.words.emplace_back(musical_scales()[i].first, i);
  }
  Section section(node, mistakes);
  section.optional("every", music.every, Range{.at_least = 0.01, .at_most = 60.0, .unit = "s"});
  section.required("parts", music.parts, rules);
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
