#include "idiophone/foundation/deck/tree.hpp"
#include "idiophone/scene/resolved_deck.hpp"
#include "idiophone/scene/scene_file.hpp"

namespace idiophone::scene {

namespace {

/// Bodies that feel the pressure of the air are computed, not read.
void check_back(Section& deck, const Scene& scene) {
  if (!scene.radiation.grid.back) {
    return;
  }
  const Node& back = *Section(*deck.find("radiation"), deck.mistakes()).find("back");
  for (const RecordedBody& body : scene.recorded_bodies) {
    deck.mistakes().add(
        back, "the air cannot act on the recorded body " + body.name + "; compute this body, too, or leave back out");
  }
}

void read_parts(Section& deck, Scene& scene) {
  deck.required("time", scene.time);
  deck.optional("materials", scene.materials);
  add_shipped(scene.materials);
  read_bodies(deck, scene);
  deck.optional("obstacles", scene.obstacles, scene);
  read_contacts(deck, scene);
  if (const Node* loads = deck.find("loads")) {
    read_loads(*loads, deck.mistakes(), scene);
  }
  read_joints(deck, scene);
  deck.optional("gauges", scene.gauges, scene);
  deck.optional("gravity", scene.gravity, Range{.at_least = -1e6, .at_most = 1e6, .unit = "m/s2"});
  require_some(deck, "listeners", scene.listeners, Folder{scene.deck.parent_path()});
  deck.optional("audio", scene.audio, default_dc_block(deck));
  deck.optional("radiation", scene.radiation, scene.audio);
  check_back(deck, scene);
  refuse_fracture(scene.bodies, scene.radiation, deck.mistakes());
  deck.optional("output", scene.output, scene.audio);
  deck.optional("references", scene.references);
}

/// A deck that has been read, and its tree with what its readers noted.
struct ReadDeck {
  Scene scene;
  Node tree;
};

ReadDeck read_with_tree(const std::filesystem::path& deck, const std::vector<std::string>& overrides) {
  Scene scene;
  Node tree = read_scene_file(deck, overrides, scene, [&](Section& section) { read_parts(section, scene); });
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
