#include <algorithm>
#include <array>
#include <initializer_list>
#include <string_view>

#include "idiophone/foundation/deck/overrides.hpp"
#include "idiophone/foundation/deck/tree.hpp"
#include "idiophone/scene/listening.hpp"
#include "idiophone/scene/scene_file.hpp"

namespace idiophone::scene {

namespace {

Node* child_of(Node& map, const std::string& key) {
  const auto found = std::ranges::find(map.children, key, &Node::key);
  return found == map.children.end() ? nullptr : &*found;
}

void put(Node& map, const Node& child) {
  if (Node* present = child_of(map, child.key)) {
    *present = child;
  } else {
    map.children.push_back(child);
  }
}

/// What may be heard otherwise, of the run's own deck.
Node listenable(const Node& deck) {
  Node part = deck;
  const auto keep = [](Node& map, const std::vector<std::string>& keys) {
    std::erase_if(map.children, [&](const Node& child) { return std::ranges::find(keys, child.key) == keys.end(); });
  };
  keep(part, {"listeners", "radiation", "audio", "output"});
  for (Node& section : part.children) {
    if (section.key == "radiation") {
      std::erase_if(section.children, [](const Node& child) { return child.key == "back"; });
      if (Node* air = child_of(section, "air")) {
        keep(*air, {"absorption", "temperature", "humidity", "pressure"});
      }
    } else if (section.key == "audio") {
      keep(section, {"dc_block", "dc_corner"});
    } else if (section.key == "output") {
      keep(section, {"wav", "wav_full_scale"});
    }
  }
  return part;
}

/// Puts what a deck says in the place of what was said before: all listeners, and single keys of other sections.
void merge(Node& before, const Node& deck) {
  for (const Node& section : deck.children) {
    Node* present = child_of(before, section.key);
    if (present == nullptr || section.key == "listeners" || section.kind != Node::Kind::map ||
        present->kind != Node::Kind::map) {
      put(before, section);
      continue;
    }
    const auto is_dc = [](const Node& child) { return child.key == "dc_block" || child.key == "dc_corner"; };
    if (std::ranges::any_of(section.children, is_dc)) {
      std::erase_if(present->children, is_dc);  // two ways of saying the same
    }
    for (const Node& child : section.children) {
      put(*present, child);
    }
  }
}

/// What the recording says has no default: a resolved deck with such keys could not be read again.
void forget_defaults(const Node& radiation) {
  const auto forget = [](const Node& map, std::initializer_list<std::string_view> keys) {
    std::erase_if(map.defaults, [&](const Node& entry) { return std::ranges::find(keys, entry.key) != keys.end(); });
  };
  forget(radiation, {"back"});
  for (const std::vector<Node>* entries :
       std::array<const std::vector<Node>*, 2>{&radiation.children, &radiation.defaults}) {
    const auto air = std::ranges::find(*entries, "air", &Node::key);
    if (air != entries->end()) {
      forget(*air, {"density", "speed"});
    }
  }
}

/// The rate is the recording's; only the DC block can differ.
void read_audio(Section& deck, int rate, Audio& audio) {
  Node no_keys;
  no_keys.kind = Node::Kind::map;
  const Node* given = deck.find("audio");
  Section section(given == nullptr ? no_keys : *given, deck.mistakes());
  audio.rate = rate;
  read_dc_block(section, audio, rate, default_dc_block(deck));
  section.finish();
}

void read_scene(Section& deck, const RecordedDeck& recorded, Scene& scene) {
  Mistakes& mistakes = deck.mistakes();
  scene.name = recorded.name + "_listen";
  if (deck.optional("name", scene.name) && deck.find("name") != nullptr) {
    check_name(scene.name, deck.find("name")->where, mistakes);
  }
  if (!recorded.has_times) {
    for (const char* key : {"audio", "output"}) {
      deck.refuse(key, "has no effect: what was recorded are single frequencies, not a sound in time");
    }
  }
  require_some(deck, "listeners", scene.listeners, Folder{scene.deck.parent_path()});
  read_audio(deck, recorded.rate, scene.audio);
  if (const Node* radiation = deck.find("radiation")) {
    if (const Node* air = Section(*radiation, mistakes).find("air")) {
      for (const char* key : {"density", "speed"}) {
        Section(*air, mistakes).refuse(key, "is given by the recording; another value needs another run");
      }
    }
    Section(*radiation, mistakes)
        .refuse("back", "the air acts on bodies that are computed; a recording keeps its motion");
    read(*radiation, mistakes, scene.radiation, scene.audio);
    forget_defaults(*radiation);
  }
  scene.radiation.air.density = recorded.air.density;
  scene.radiation.air.speed = recorded.air.speed;
  if (const Node* output = deck.find("output")) {
    Section section(*output, mistakes);
    read_wav(section, scene.output);
    section.finish();
  }
  deck.finish();
  check_listeners(scene, mistakes);
}

/// A deck for listening, and its tree with what its readers noted.
struct ReadListening {
  Scene scene;
  Node tree;
};

ReadListening read_listening_with_tree(const RecordedDeck& recorded, const std::filesystem::path& deck,
                                       const std::vector<std::string>& overrides) {
  Scene scene;
  Mistakes mistakes;
  const std::string place = recorded.recording.string();
  Node tree;
  tree.kind = Node::Kind::map;
  tree.where = {place, 1, 1};
  if (!recorded.text.empty()) {
    const Node whole = read_tree(recorded.text, place + ":/deck", recorded.overrides, mistakes);
    tree = listenable(whole);
    if (!recorded.has_times) {
      std::erase_if(tree.children, [](const Node& child) { return child.key == "audio" || child.key == "output"; });
    }
    Section(whole, mistakes).optional("references", scene.references);
  }
  scene.deck = deck.empty() ? recorded.recording : deck;
  scene.deck_text = deck.empty() ? recorded.text : deck::read_text(deck);
  if (deck.empty()) {
    scene.overrides = recorded.overrides;
  } else {
    merge(tree, read_tree(scene.deck_text, deck.string(), {}, mistakes));
  }
  for (const std::string& argument : overrides) {
    apply_override(tree, argument, mistakes);
    scene.overrides.push_back(argument);
  }
  Section section(tree, mistakes);
  read_scene(section, recorded, scene);
  mistakes.raise();
  return {std::move(scene), std::move(tree)};
}

}  // namespace

Scene read_listening(const RecordedDeck& recorded, const std::filesystem::path& deck,
                     const std::vector<std::string>& overrides) {
  return read_listening_with_tree(recorded, deck, overrides).scene;
}

std::string resolved_listening(const RecordedDeck& recorded, const std::filesystem::path& deck,
                               const std::vector<std::string>& overrides) {
  return deck::resolved(read_listening_with_tree(recorded, deck, overrides).tree);
}

}  // namespace idiophone::scene
