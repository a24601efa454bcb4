#include "idiophone/scene/sonic_scene.hpp"

#include <algorithm>
#include <cmath>

#include "ranges.hpp"
#include "scene_file.hpp"

namespace idiophone::scene {

namespace {

constexpr Range sonic_time{.at_least = 0.0, .at_most = 86400.0, .unit = "s"};
constexpr Range sonic_length{.above = 0.0, .at_most = 86400.0, .unit = "s"};

/// A list of two numbers.
struct NumberPair {};

bool read(const Node& node, Mistakes& mistakes, std::array<double, 2>& pair, const NumberPair& /*rule*/) {
  if (node.kind != Node::Kind::list || node.children.size() != 2) {
    return mistakes.add(node, "expected a list of 2 numbers, found " + describe(node));
  }
  return read(node.children[0], mistakes, pair[0], Range{}) && read(node.children[1], mistakes, pair[1], Range{});
}

/// One number or a list of them.
struct StartTimes {};

bool read(const Node& node, Mistakes& mistakes, std::vector<double>& starts, const StartTimes& /*rule*/) {
  const auto read_one = [&](const Node& item) {
    double time = 0.0;
    const bool good = read(item, mistakes, time, sonic_time);
    starts.push_back(time);
    return good;
  };
  return node.kind == Node::Kind::list ? std::ranges::all_of(node.children, read_one) : read_one(node);
}

/// The words of interpolation.
const Choices<Interpolation>& interpolations() {
  static const Choices<Interpolation> words{
      {{"linear", Interpolation::linear}, {"cubic", Interpolation::cubic}, {"hold", Interpolation::hold}}};
  return words;
}

void read_mapping(Section& section, Mapping& mapping) {
  section.optional("scale", mapping.scale, Range{});
  section.optional("offset", mapping.offset, Range{});
  section.optional("curve", mapping.curve, Range{.above = 0.0, .at_most = 100.0});
  if (section.optional("range", mapping.range, NumberPair{}) && mapping.range &&
      (*mapping.range)[0] > (*mapping.range)[1]) {
    section.mistakes().add(*section.find("range"), "the first number is the lower one");
  }
}

void read_channel(Section& section, MotionVariable& motion) {
  motion.where = section.node().where;
  if (section.required("channel", motion.channel)) {
    motion.where = section.find("channel")->where;
  }
  if (section.find("column") != nullptr) {
    section.required("column", motion.column);
  }
  section.optional("interpolation", motion.interpolation, interpolations());
}

bool read_keyframes(Section& section, Keyframes& keyframes) {
  section.optional("interpolation", keyframes.interpolation, interpolations());
  const bool good = section.required("keys", keyframes.keys, NumberPair{});
  if (good && keyframes.keys.empty()) {
    return section.mistakes().add(*section.find("keys"), "is empty; it needs at least one row of time and value");
  }
  const auto ascends = [](const auto& a, const auto& b) { return a[0] >= b[0]; };
  if (good && std::ranges::adjacent_find(keyframes.keys, ascends) != keyframes.keys.end()) {
    return section.mistakes().add(*section.find("keys"), "times must ascend");
  }
  return good;
}

void read_event_variable(Section& section, EventVariable& event) {
  const Choices<EventVariable::Quantity> quantities{
      {{"force", EventVariable::Quantity::force}, {"impulse", EventVariable::Quantity::impulse}}};
  section.required("event", event.quantity, quantities);
  read_mapping(section, event.mapping);
}

/// What a parameter may be bound to by name.
struct VariableRules {
  std::vector<NamedVariable> named;
};

bool read_variable_name(const Node& node, Mistakes& mistakes, Variable& variable, const VariableRules& rules) {
  const auto found = std::ranges::find(rules.named, node.text, &NamedVariable::name);
  if (found == rules.named.end()) {
    std::vector<std::string> names;
    for (const NamedVariable& named : rules.named) {
      names.push_back(named.name);
    }
    return mistakes.add(node, "there is no variable " + describe(node) + suggestion(node.text, names));
  }
  variable = found->variable;
  return true;
}

bool read(const Node& node, Mistakes& mistakes, NamedVariable& named, const VariableRules& rules) {
  named.where = node.where;
  if (node.kind == Node::Kind::scalar && !node.text.empty() && std::isalpha(node.text.front()) != 0) {
    return read_variable_name(node, mistakes, named.variable, rules);
  }
  if (node.kind != Node::Kind::map) {
    double number = 0.0;
    const bool good = read(node, mistakes, number, Range{});
    named.variable = number;
    return good;
  }
  Section section(node, mistakes);
  if (section.find("keys") != nullptr) {
    read_keyframes(section, named.variable.emplace<Keyframes>());
  } else if (section.find("event") != nullptr) {
    read_event_variable(section, named.variable.emplace<EventVariable>());
  } else {
    auto& motion = named.variable.emplace<MotionVariable>();
    read_channel(section, motion);
    read_mapping(section, motion.mapping);
  }
  return section.finish();
}

struct ClassRules {
  Folder folder;
};

bool read(const Node& node, Mistakes& mistakes, SoundClass& sound_class, const ClassRules& rules) {
  return read(node, mistakes, sound_class.tree, rules.folder);
}

bool read_contact_start(const Node& node, Mistakes& mistakes, ContactStart& start) {
  Section section(node, mistakes);
  start.where = node.where;
  section.required("name", start.contact);
  section.required("above", start.above, Range{.at_least = 0.0, .unit = "N"});
  section.optional("gap", start.gap, sonic_time);
  return section.finish();
}

struct SoundRules {
  Choices<std::size_t> classes;
  VariableRules variables;
  Folder folder;
};

bool uses_event(const NamedVariable& parameter) {
  return std::holds_alternative<EventVariable>(parameter.variable);
}

void read_starts(Section& section, SonicSound& sound) {
  const Node* contact = section.find("contact");
  if (contact == nullptr) {
    sound.starts = {0.0};
    if (section.find("start") != nullptr) {
      sound.starts.clear();
      section.required("start", sound.starts, StartTimes{});
    }
    if (std::ranges::any_of(sound.parameters, uses_event)) {
      section.mistakes().add(section.node(),
                             "a parameter is bound to an event; give the contact that starts the sound");
    }
    return;
  }
  section.refuse("start", "the contact starts the sound; give one of the two");
  read_contact_start(*contact, section.mistakes(), sound.on_contact.emplace());
}

/// The keys at, path and body: one of them, or none.
void read_source_place(Section& section, SonicSound& sound, const Folder& folder) {
  section.optional("at", sound.at, coordinate);
  section.optional("path", sound.path, folder);
  if (section.find("body") != nullptr) {
    section.required("body", sound.body);
  }
  if (static_cast<int>(sound.at.has_value()) + static_cast<int>(sound.path.has_value()) +
          static_cast<int>(!sound.body.empty()) >
      1) {
    section.mistakes().add(section.node(), "a sound has one place; give one of at, path and body");
  }
}

bool read(const Node& node, Mistakes& mistakes, SonicSound& sound, const SoundRules& rules) {
  Section section(node, mistakes);
  sound.where = node.key_where;
  section.required("class", sound.sound_class, rules.classes);
  if (section.find("parameters") != nullptr) {
    section.required("parameters", sound.parameters, rules.variables);
  }
  read_starts(section, sound);
  if (section.find("duration") != nullptr) {
    section.required("duration", sound.duration, sonic_length);
  }
  section.optional("gain", sound.gain, Range{});
  read_source_place(section, sound, rules.folder);
  return section.finish();
}

struct ReverberationKeys {};

bool read(const Node& node, Mistakes& mistakes, Reverberation& reverberation, const ReverberationKeys& /*rule*/) {
  Section section(node, mistakes);
  section.required("decay", reverberation.decay, Range{.above = 0.0, .at_most = 100.0, .unit = "s"});
  section.optional("level", reverberation.level, Range{.at_least = 0.0, .at_most = 100.0});
  return section.finish();
}

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

struct MusicKeys {};

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

/// Sources are points, so only the air and the floor matter.
void read_sonic_radiation(Section& section, Scene& scene) {
  if (const Node* radiation = section.find("radiation")) {
    Section keys(*radiation, section.mistakes());
    for (const char* key : {"model", "surface_pressure", "visibility"}) {
      keys.refuse(key, "has no meaning for the sounds of a sonic scene; leave it out");
    }
    section.optional("radiation", scene.radiation, scene.audio);
  }
  scene.radiation.model = RadiationModel::rayleigh;
}

void read_sounds(Section& section, SonicScene& sonic, const std::filesystem::path& folder) {
  section.required("classes", sonic.classes, ClassRules{{folder}});
  SoundRules rules{.classes = names_of(sonic.classes), .variables = {}, .folder = {folder}};
  if (section.find("variables") != nullptr) {
    section.required("variables", rules.variables.named, VariableRules{});
  }
  section.required("sounds", sonic.sounds, rules);
}

}  // namespace

double Mapping::operator()(double number) const {
  const double value = offset + scale * std::copysign(std::pow(std::abs(number), curve), number);
  return range ? std::clamp(value, (*range)[0], (*range)[1]) : value;
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

SonicScene read_sonic_scene(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  SonicScene sonic;
  Scene& scene = sonic.scene;
  read_scene_file(file, overrides, scene, [&](Section& section) {
    section.required("duration", sonic.duration, sonic_length);
    section.optional("rate", scene.audio.rate, Range{.at_least = 8000.0, .at_most = 192000.0, .unit = "Hz"});
    int seed = 1;
    section.optional("seed", seed, Range{.at_least = 0.0});
    sonic.seed = static_cast<std::uint64_t>(seed);
    read_sounds(section, sonic, file.parent_path());
    if (section.find("listeners") != nullptr) {
      section.required("listeners", scene.listeners, Folder{file.parent_path()});
    }
    refuse_attached(scene.listeners, section.mistakes());
    read_sonic_radiation(section, scene);
    section.optional("reverberation", sonic.reverberation, ReverberationKeys{});
    section.optional("music", sonic.music, MusicKeys{});
    read_wav(section, scene.output);
  });
  return sonic;
}

}  // namespace idiophone::scene
