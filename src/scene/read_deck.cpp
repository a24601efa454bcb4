#include "idiophone/deck/tree.hpp"
#include "idiophone/scene/resolved_deck.hpp"
#include "sections.hpp"

namespace idiophone::scene {

namespace {

/// A section of named things that must not be empty.
template <class T, class... Rules>
void require_some(Section& deck, const std::string& key, std::vector<T>& things, const Rules&... rules) {
  if (deck.required(key, things, rules...) && things.empty()) {
    deck.mistakes().add(*deck.find(key), "is empty; it needs at least one entry");
  }
}

void read_scene(Section& deck, Scene& scene) {
  if (deck.required("name", scene.name)) {
    check_name(scene.name, deck.find("name")->where, deck.mistakes());
  }
  deck.required("time", scene.time);
  deck.optional("materials", scene.materials);
  add_shipped(scene.materials);
  read_bodies(deck, scene);
  deck.optional("obstacles", scene.obstacles, scene);
  read_contacts(deck, scene);
  if (const Node* loads = deck.find("loads")) {
    read_loads(*loads, deck.mistakes(), scene);
  }
  deck.optional("gravity", scene.gravity, Range{.at_least = -1e6, .at_most = 1e6, .unit = "m/s2"});
  require_some(deck, "listeners", scene.listeners, Folder{scene.deck.parent_path()});
  deck.optional("audio", scene.audio);
  deck.optional("radiation", scene.radiation, scene.audio);
  deck.optional("output", scene.output, scene.audio);
  deck.optional("references", scene.references);
  deck.finish();
  check_listeners(scene, deck.mistakes());
}

/// A deck that has been read, and its tree with what its readers noted.
struct ReadDeck {
  Scene scene;
  Node tree;
};

ReadDeck read_with_tree(const std::filesystem::path& deck, const std::vector<std::string>& overrides) {
  Scene scene;
  scene.deck = deck;
  scene.deck_text = deck::read_text(deck);
  scene.overrides = overrides;
  Mistakes mistakes;
  Node tree = read_tree(scene.deck_text, deck.string(), overrides, mistakes);
  Section section(tree, mistakes);
  read_scene(section, scene);
  mistakes.raise();
  return {std::move(scene), std::move(tree)};
}

}  // namespace

Scene read_deck(const std::filesystem::path& deck, const std::vector<std::string>& overrides) {
  return read_with_tree(deck, overrides).scene;
}

std::string resolved_deck(const std::filesystem::path& deck, const std::vector<std::string>& overrides) {
  return deck::resolved(read_with_tree(deck, overrides).tree);
}

}  // namespace idiophone::scene
