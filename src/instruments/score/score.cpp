#include "idiophone/instruments/score/score.hpp"

#include "actions.hpp"
#include "contact_keys.hpp"
#include "idiophone/foundation/deck/tree.hpp"
#include "idiophone/scene/ranges.hpp"
#include "idiophone/scene/sections.hpp"

namespace idiophone::score {

using namespace deck;  // values, keys and sections

namespace {

constexpr Range seconds{.at_least = 0.0, .at_most = 86400.0, .unit = "s"};

enum class EventType { blow, mallet, force, scrape, roll, bow, tune, detail };

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
                                  {"mallet", EventType::mallet},
                                  {"force", EventType::force},
                                  {"scrape", EventType::scrape},
                                  {"roll", EventType::roll},
                                  {"bow", EventType::bow},
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
  } else if (type == EventType::mallet) {
    read_mallet_blow(section, event.action.emplace<MalletBlow>());
  } else if (type == EventType::force) {
    read_applied_force(section, event.action.emplace<AppliedForce>(), rules.folder, rules.when);
  } else if (type == EventType::bow) {
    Bow& bow = event.action.emplace<Bow>();
    read_bow(section, bow);
    section.optional("duration", bow.duration, Range{.above = 0.0, .at_most = longest_force, .unit = "s"});
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
  const Choices<EventType> types{
      {{"blow", EventType::blow}, {"scrape", EventType::scrape}, {"roll", EventType::roll}, {"bow", EventType::bow}}};
  EventType type = EventType::blow;
  if (!section.optional("type", type, types)) {
    return false;  // the other keys depend on it
  }
  if (type == EventType::blow) {
    read_hammer_blow(section, note.blow);
  } else if (type == EventType::bow) {
    read_bow(section, note.bow.emplace());
    section.refuse("duration", "the bow stays until the key is released; leave it out");
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
  section.optional("contacts", score.contacts, ContactRule{rules.bodies});
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
