#include "idiophone/instruments/score/score.hpp"

#include <cmath>
#include <numbers>

#include "idiophone/foundation/deck/tree.hpp"
#include "idiophone/scene/ranges.hpp"
#include "idiophone/scene/sections.hpp"

namespace idiophone::score {

using namespace deck;  // values, keys and sections

namespace {

constexpr Range seconds{.at_least = 0.0, .at_most = 86400.0, .unit = "s"};
constexpr Range hammer_mass{.at_least = 1e-9, .at_most = 1e6, .unit = "kg"};
constexpr Range hertz_hardness{.at_least = 1.0, .at_most = 1e15, .unit = "N/m^(3/2)"};
constexpr Range hammer_speed{.at_least = 1e-6, .at_most = 1e3, .unit = "m/s"};
constexpr Range small_length{.at_least = 1e-9, .at_most = 10.0, .unit = "m"};
constexpr double longest_force = 60.0;         // s, of a stroke or a force
constexpr double longest_contact = 1.0;        // s, of a blow
constexpr double most_waves_of_profile = 1e7;  // in a stroke

using BodyNames = Choices<std::size_t>;

void read_body(Section& section, std::size_t& body, const BodyNames& bodies) {
  if (bodies.words.size() > 1) {
    section.required("body", body, bodies);
  } else {
    section.optional("body", body, bodies);
  }
}

void read_hammer_blow(Section& section, HammerBlow& blow) {
  section.required("at", blow.at, scene::coordinate);
  section.required("direction", blow.direction, scene::unit_vector);
  const bool has_mass = section.required("mass", blow.hammer.mass, hammer_mass);
  const bool has_hardness = section.required("hardness", blow.hammer.hardness, hertz_hardness);
  if (section.required("speed", blow.hammer.speed, hammer_speed) && has_mass && has_hardness &&
      blow.hammer.contact_duration() > longest_contact) {
    section.mistakes().add(section.node(), fmt::format("touches for {:.4g} s; a blow can take {} s. Raise the hardness",
                                                       blow.hammer.contact_duration(), longest_contact));
  }
}

/// When events happen: at a time that they have, or at once, because somebody far away may ask for it.
enum class When { by_time, at_once };

void read_applied_force(Section& section, AppliedForce& applied, const Folder& folder, When when) {
  section.required("at", applied.at, scene::coordinate);
  section.required("force", applied.force, scene::force_component);
  if (when == When::at_once && section.find("table") != nullptr) {
    for (const char* key : {"shape", "start", "duration", "frequency"}) {
      section.know(key);
    }
    section.refuse("table", "an event that is sent can't name files");
    return;
  }
  if (scene::read_signal(section, folder, applied.signal) && !(applied.end() <= longest_force)) {
    section.mistakes().add(
        section.node(), fmt::format("ends after {} s; a force has to end within {} s", applied.end(), longest_force));
  }
}

/// roughness: {height, exponent, longest, shortest}
struct RoughnessKeys {};

bool read(const Node& node, Mistakes& mistakes, Roughness& roughness, const RoughnessKeys& /*rule*/) {
  Section section(node, mistakes);
  section.required("height", roughness.height, Range{.at_least = 0.0, .at_most = 1.0, .unit = "m"});
  section.optional("exponent", roughness.exponent, Range{.at_least = 0.0, .at_most = 4.0});
  const bool has_longest = section.optional("longest", roughness.longest, small_length);
  if (section.optional("shortest", roughness.shortest, small_length) && has_longest &&
      roughness.shortest >= roughness.longest) {
    mistakes.add(node, fmt::format("the shortest wavelength, {} m, must be below the longest, {} m", roughness.shortest,
                                   roughness.longest));
  }
  return section.finish();
}

void check_stroke(Section& section, const Stroke& stroke) {
  const double distance = (stroke.to - stroke.from).norm();
  if (distance <= 0.0) {
    section.mistakes().add(section.node(), "from and to are the same point; the contact must move");
  } else if (distance / stroke.speed > longest_force) {
    section.mistakes().add(
        section.node(), fmt::format("takes {:.4g} s; a stroke can take {} s", distance / stroke.speed, longest_force));
  } else if (distance / stroke.roughness.shortest > most_waves_of_profile) {
    section.mistakes().add(section.node(), fmt::format("has {:.4g} of the shortest waves of its roughness; {} are "
                                                       "possible. Raise roughness.shortest",
                                                       distance / stroke.roughness.shortest, most_waves_of_profile));
  }
}

void read_stroke(Section& section, Stroke& stroke) {
  const std::size_t before = section.mistakes().count();
  section.required("from", stroke.from, scene::coordinate);
  section.required("to", stroke.to, scene::coordinate);
  section.required("direction", stroke.direction, scene::unit_vector);
  section.required("speed", stroke.speed, hammer_speed);
  section.required("load", stroke.load, Range{.above = 0.0, .at_most = 1e6, .unit = "N"});
  section.required("mass", stroke.mass, hammer_mass);
  section.required("hardness", stroke.hardness, hertz_hardness);
  section.optional("size", stroke.size, Range{.at_least = 0.0, .at_most = 1.0, .unit = "m"});
  if (stroke.kind == Stroke::Kind::scrape) {
    section.optional("friction", stroke.friction, Range{.at_least = 0.0, .at_most = 10.0});
  } else {
    section.refuse("friction", "a body that rolls does not slide; leave it out");
  }
  section.required("roughness", stroke.roughness, RoughnessKeys{});
  if (section.mistakes().count() == before) {
    check_stroke(section, stroke);
  }
}

void read_tuning(Section& section, Tuning& tuning) {
  section.optional("size", tuning.size, Range{.at_least = 0.01, .at_most = 100.0});
  section.optional("friction", tuning.friction, Range{.at_least = 0.0, .at_most = 1e6});
  section.optional("tension", tuning.tension, Range{.at_least = 1e-4, .at_most = 1e4});
}

template <class Value>
void read_if_given(Section& section, const std::string& key, std::optional<Value>& value, const Range& range) {
  if (section.find(key) != nullptr) {
    section.required(key, value.emplace(), range);
  }
}

void read_detail(Section& section, Detail& detail) {
  read_if_given(section, "level", detail.level, Range{.at_least = -1.0, .at_most = 5.0});
  read_if_given(section, "priority", detail.priority, Range{.at_least = -1e9, .at_most = 1e9});
  read_if_given(section, "budget", detail.budget, Range{.at_least = 1e-6, .at_most = 1e6});
  read_if_given(section, "most_active", detail.most_active, Range{.at_least = 1.0, .at_most = 1e6});
  if (!detail.level && !detail.priority && !detail.budget && !detail.most_active) {
    section.mistakes().add(section.node(), "changes nothing; give level, priority, budget or most_active");
  }
}

enum class EventType { blow, force, scrape, roll, tune, detail };

/// What an event or note needs to know of the rest.
struct ScoreRules {
  Folder folder;
  BodyNames bodies;
  When when = When::by_time;

  ScoreRules(std::filesystem::path path, const std::vector<std::string>& names, When rule)
      : folder{std::move(path)}, when(rule) {
    for (std::size_t i = 0; i < names.size(); ++i) {
      bodies.words.emplace_back(names[i], i);
    }
  }
};

bool read(const Node& node, Mistakes& mistakes, ScoreEvent& event, const ScoreRules& rules) {
  const Choices<EventType> types{{{"blow", EventType::blow},
                                  {"force", EventType::force},
                                  {"scrape", EventType::scrape},
                                  {"roll", EventType::roll},
                                  {"tune", EventType::tune},
                                  {"detail", EventType::detail}}};
  Section section(node, mistakes);
  EventType type = EventType::blow;
  if (!section.optional("type", type, types)) {
    return false;  // the other keys depend on it
  }
  if (rules.when == When::by_time) {
    section.required("time", event.time, seconds);
  } else {
    section.refuse("time", "this happens at once; leave it out");
  }
  read_body(section, event.body, rules.bodies);
  if (type == EventType::blow) {
    read_hammer_blow(section, event.action.emplace<HammerBlow>());
  } else if (type == EventType::force) {
    read_applied_force(section, event.action.emplace<AppliedForce>(), rules.folder, rules.when);
  } else if (type == EventType::tune) {
    read_tuning(section, event.action.emplace<Tuning>());
  } else if (type == EventType::detail) {
    read_detail(section, event.action.emplace<Detail>());
  } else {
    Stroke& stroke = event.action.emplace<Stroke>();
    stroke.kind = type == EventType::roll ? Stroke::Kind::roll : Stroke::Kind::scrape;
    read_stroke(section, stroke);
  }
  return section.finish();
}

bool read(const Node& node, Mistakes& mistakes, NoteAction& note, const ScoreRules& rules) {
  Section section(node, mistakes);
  section.required("note", note.note, Range{.at_least = 0.0, .at_most = 127.0});
  read_body(section, note.body, rules.bodies);
  const Choices<EventType> types{{{"blow", EventType::blow}, {"scrape", EventType::scrape}, {"roll", EventType::roll}}};
  EventType type = EventType::blow;
  if (!section.optional("type", type, types)) {
    return false;  // the other keys depend on it
  }
  if (type == EventType::blow) {
    read_hammer_blow(section, note.blow);
  } else {
    note.stroke.emplace().kind = type == EventType::roll ? Stroke::Kind::roll : Stroke::Kind::scrape;
    read_stroke(section, *note.stroke);
  }
  return section.finish();
}

bool read(const Node& node, Mistakes& mistakes, MotionForce& motion, const ScoreRules& rules) {
  Section section(node, mistakes);
  section.required("channel", motion.channel);
  if (section.find("column") != nullptr) {
    section.required("column", motion.column);
  }
  read_body(section, motion.body, rules.bodies);
  section.required("at", motion.at, scene::coordinate);
  section.required("force", motion.force, scene::force_component);
  section.optional("above", motion.above, Range{.at_least = 0.0});
  return section.finish();
}

void check_notes(const Section& score, const std::vector<NoteAction>& notes, Mistakes& mistakes) {
  for (std::size_t i = 0; i < notes.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (notes[i].note == notes[j].note) {
        mistakes.add(score.node(), fmt::format("notes: note {} is there twice", notes[i].note));
      }
    }
  }
}

/// A listener that moves must be slower than sound in any air that sound maps have. No body carries it.
void check_listener(const std::optional<scene::Listener>& listener, Mistakes& mistakes) {
  constexpr double fastest = 100.0;  // m/s
  if (listener) {
    scene::refuse_attached({&*listener, 1}, mistakes);
  }
  if (listener && listener->path && listener->path->fastest() > fastest) {
    mistakes.add(listener->path->where, fmt::format("listener.path: moves at up to {:.4g} m/s; at most {} m/s are "
                                                    "possible",
                                                    listener->path->fastest(), fastest));
  }
}

}  // namespace

double Hammer::contact_duration() const {
  static const double factor = 0.8 * std::sqrt(std::numbers::pi) * std::tgamma(0.4) / std::tgamma(0.9);  // 2.9433
  return factor * std::pow(1.25 * mass * speed * speed / hardness, 0.4) / speed;
}

double AppliedForce::end() const {
  return signal.end();
}

Score read_score(const std::filesystem::path& file, const std::vector<std::string>& bodies,
                 const std::vector<std::string>& overrides) {
  Score score;
  score.file = file;
  const ScoreRules rules(file.parent_path(), bodies, When::by_time);
  Mistakes mistakes;
  const Node tree = deck::read_tree(deck::read_text(file), file.string(), overrides, mistakes);
  Section section(tree, mistakes);
  int seed = 1;
  section.required("duration", score.duration, Range{.above = 0.0, .at_most = seconds.at_most, .unit = "s"});
  section.optional("seed", seed, Range{.at_least = 0.0, .at_most = 2e9});
  section.optional("listener", score.listener, rules.folder);
  section.optional("events", score.events, rules);
  section.optional("notes", score.notes, rules);
  section.optional("motion", score.motion, rules);
  scene::Output output;
  scene::read_wav(section, output);
  section.finish();
  check_notes(section, score.notes, mistakes);
  check_listener(score.listener, mistakes);
  mistakes.raise();
  score.seed = static_cast<std::uint64_t>(seed);
  score.wav = output.wav;
  score.wav_full_scale = output.wav_full_scale;
  return score;
}

ScoreEvent read_event(const std::string& text, const std::string& source, const std::vector<std::string>& bodies) {
  ScoreEvent event;
  Mistakes mistakes;
  const Node tree = deck::read_tree(text, source, {}, mistakes);
  read(tree, mistakes, event, ScoreRules({}, bodies, When::at_once));
  mistakes.raise();
  return event;
}

scene::Scene as_scored(scene::Scene scene, const Score& score) {
  scene.time.duration = score.duration;
  if (score.listener) {
    scene.listeners.assign(1, *score.listener);
    scene.listeners.front().name = "listener";
  }
  return scene;
}

}  // namespace idiophone::score
