#include "idiophone/instruments/sound_maps/ideal_deck.hpp"

#include <algorithm>

#include "ideal_bodies.hpp"
#include "idiophone/foundation/deck/tree.hpp"
#include "idiophone/scene/scene_file.hpp"

namespace idiophone::sound_maps {

using namespace deck;  // values, keys and sections

namespace {

/// Reports listeners that hear nothing of a body, because they are in its wall or behind it.
void check_listeners(const IdealDeck& deck, Mistakes& mistakes) {
  for (const scene::Listener& listener : deck.scene.listeners) {
    for (const IdealBody& body : deck.bodies) {
      const double wall = body.position[2];
      const auto is_behind = [&](const scene::Receiver& receiver) {
        return listener.place(receiver, 0.0).position[2] <= wall;
      };
      if (std::ranges::any_of(listener.receivers, is_behind)) {
        mistakes.add(
            listener.where,
            fmt::format("listeners.{}: hears nothing of body '{}', which sounds in front of its wall only: the "
                        "z of its position must be above {:.6g} m",
                        listener.name, body.name, wall));
        break;
      }
    }
  }
}

/// A deck that has been read, and its tree with what its readers noted.
struct ReadIdealDeck {
  IdealDeck deck;
  Node tree;
};

ReadIdealDeck read_ideal_deck_with_tree(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  IdealDeck deck;
  scene::Scene& scene = deck.scene;
  Node tree = scene::read_scene_file(file, overrides, scene, [&](Section& section) {
    const Folder folder{file.parent_path()};
    scene::require_some(section, "ideal_bodies", deck.bodies, folder);
    scene::require_some(section, "listeners", scene.listeners, folder);
    section.optional("radiation", scene.radiation, scene.audio);
    scene::refuse_attached(scene.listeners, section.mistakes());
    if (section.mistakes().count() == 0) {  // else places may be missing
      check_listeners(deck, section.mistakes());
    }
  });
  return {std::move(deck), std::move(tree)};
}

}  // namespace

bool has_ideal_bodies(const std::filesystem::path& deck, const std::vector<std::string>& overrides) {
  return has_key(deck, overrides, "ideal_bodies");
}

IdealDeck read_ideal_deck(const std::filesystem::path& deck, const std::vector<std::string>& overrides) {
  return read_ideal_deck_with_tree(deck, overrides).deck;
}

std::string resolved_ideal_deck(const std::filesystem::path& deck, const std::vector<std::string>& overrides) {
  return deck::resolved(read_ideal_deck_with_tree(deck, overrides).tree);
}

}  // namespace idiophone::sound_maps
