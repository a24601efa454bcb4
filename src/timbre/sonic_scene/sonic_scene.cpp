#include "idiophone/timbre/sonic_scene/sonic_scene.hpp"

#include <algorithm>
#include <cmath>

#include "idiophone/scene/ranges.hpp"
#include "idiophone/scene/scene_file.hpp"
#include "idiophone/scene/sections.hpp"
#include "sonic_music.hpp"
#include "sonic_objects.hpp"
#include "sonic_variables.hpp"

namespace idiophone::timbre {

using namespace deck;  // values, keys and sections

namespace {

constexpr Range sonic_time{.at_least = 0.0, .at_most = 86400.0, .unit = "s"};
constexpr Range sonic_length{.above = 0.0, .at_most = 86400.0, .unit = "s"};

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
  read_source_place(section, sound.place, rules.folder, "a sound");
  section.optional("directivity", sound.directivity);
  if (sound.directivity && !sound.place.is_somewhere()) {
    section.mistakes().add(*section.find("directivity"), "has no meaning without a place; give at, path or body");
  }
  return section.finish();
}

struct ReverberationKeys {};

bool read(const Node& node, Mistakes& mistakes, Reverberation& reverberation, const ReverberationKeys& /*rule*/) {
  Section section(node, mistakes);
  section.required("decay", reverberation.decay, Range{.above = 0.0, .at_most = 100.0, .unit = "s"});
  section.optional("level", reverberation.level, Range{.at_least = 0.0, .at_most = 100.0});
  return section.finish();
}

/// Sources are points, so only the air, the floor and the room matter.
void read_sonic_radiation(Section& section, scene::Scene& scene) {
  if (const Node* radiation = section.find("radiation")) {
    Section keys(*radiation, section.mistakes());
    for (const char* key : {"model", "surface_pressure", "visibility"}) {
      keys.refuse(key, "has no meaning for the sounds of a sonic scene; leave it out");
    }
    section.optional("radiation", scene.radiation, scene.audio);
  }
  scene.radiation.model = scene::RadiationModel::rayleigh;
}

/// @return what music can be bound to
MusicRules read_sounds(Section& section, SonicScene& sonic, const std::filesystem::path& folder) {
  section.required("classes", sonic.classes, ClassRules{{folder}});
  SoundRules rules{.classes = scene::names_of(sonic.classes), .variables = {}, .folder = {folder}};
  if (section.find("variables") != nullptr) {
    section.required("variables", rules.variables.named, VariableRules{});
  }
  section.required("sounds", sonic.sounds, rules);
  return {.classes = std::move(rules.classes), .variables = std::move(rules.variables)};
}

}  // namespace

SonicScene read_sonic_scene(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  SonicScene sonic;
  scene::Scene& scene = sonic.scene;
  scene::read_scene_file(file, overrides, scene, [&](Section& section) {
    section.required("duration", sonic.duration, sonic_length);
    section.optional("rate", scene.audio.rate, Range{.at_least = 8000.0, .at_most = 192000.0, .unit = "Hz"});
    int seed = 1;
    section.optional("seed", seed, Range{.at_least = 0.0});
    sonic.seed = static_cast<std::uint64_t>(seed);
    const MusicRules music = read_sounds(section, sonic, file.parent_path());
    if (section.find("listeners") != nullptr) {
      section.required("listeners", scene.listeners, Folder{file.parent_path()});
    }
    section.optional("objects", sonic.objects, Folder{file.parent_path()});
    if (const Node* objects = section.find("objects"); objects != nullptr && section.find("listeners") == nullptr) {
      section.mistakes().add(*objects, "stand between sounds and listeners; give listeners");
    }
    scene::refuse_attached(scene.listeners, section.mistakes());
    read_sonic_radiation(section, scene);
    section.optional("reverberation", sonic.reverberation, ReverberationKeys{});
    section.optional("music", sonic.music, music);
    scene::read_wav(section, scene.output);
  });
  return sonic;
}

}  // namespace idiophone::timbre
