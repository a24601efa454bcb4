// Mistakes in decks of ideal bodies.

#include "idiophone/instruments/sound_maps/ideal_deck.hpp"

#include <gmock/gmock.h>

#include <fstream>

#include "idiophone/foundation/deck/location.hpp"
#include "ranks.hpp"
#include "shared_folder.hpp"

namespace idiophone::sound_maps {
namespace {

const std::string drum =
    "  drum: {type: membrane, polygon: [[0, 0], [1, 0], [1, 1], [0, 1]], tension: 100, density: 1}\n";
const std::string ear = "  ear: {type: mono, position: [0, 0, 1]}\n";

/// The mistakes of a deck, a line each, without its folder.
std::string ideal_mistakes(const std::string& bodies, const std::string& listeners) {
  const support::Folder folder;
  const std::filesystem::path file = folder.path() / "deck.yaml";
  std::ofstream(file) << "name: ideal\nideal_bodies:\n" << bodies << "listeners:\n" << listeners;
  try {
    static_cast<void>(read_ideal_deck(file, {}));
  } catch (const deck::DeckError& error) {
    std::string text = error.what();
    const std::string path = folder.path().string() + "/";
    for (std::size_t at = text.find(path); at != std::string::npos; at = text.find(path)) {
      text.erase(at, path.size());
    }
    return text;
  }
  return "no mistakes";
}

/// Those of a membrane with this polygon.
std::string polygon_mistakes(const std::string& polygon) {
  return ideal_mistakes("  drum: {type: membrane, tension: 100, density: 1, polygon: [" + polygon + "]}\n", ear);
}

ON_RANKS(1);

TEST(IdealDeck, HasPolygonsEitherWayRound) {
  EXPECT_EQ(ideal_mistakes(drum, ear), "no mistakes");
  EXPECT_EQ(polygon_mistakes("[0, 0], [0, 1], [1, 1], [1, 0]"), "no mistakes");
  EXPECT_EQ(polygon_mistakes("[0, 0], [1, 0], [2, 0], [1, 0.01]"), "no mistakes") << "three corners in one line";
}

TEST(IdealDeck, NamesTheCornersOfAPolygonAtOnePlace) {
  EXPECT_EQ(
      polygon_mistakes("[0, 0], [1, 0], [1, 1], [0, 0]"),
      "deck.yaml:3:86: ideal_bodies.drum.polygon.3: this corner, [0, 0], is at the place of corner 1: the polygon "
      "closes by itself, so leave the last one out");
  EXPECT_EQ(polygon_mistakes("[0, 0], [1, 0], [1, 0], [0, 1]"),
            "deck.yaml:3:78: ideal_bodies.drum.polygon.2: this corner, [1, 0], is at the place of corner 2: an outline "
            "passes each place once, so leave one out");
  EXPECT_THAT(polygon_mistakes("[1, 1], [1, 1], [1, 1]"), testing::HasSubstr("place of corner 1"));
}

TEST(IdealDeck, NamesTheEdgesOfAPolygonThatMeet) {
  EXPECT_EQ(
      polygon_mistakes("[0, 0], [1, 1], [1, 0], [0, 1]"),
      "deck.yaml:3:78: ideal_bodies.drum.polygon.2: the edge from [1, 0] to [0, 1] crosses or touches the edge from "
      "[0, 0] to [1, 1]: the outline must not meet itself");
  EXPECT_THAT(polygon_mistakes("[0, 0], [2, 0], [2, 1], [1, 0], [0, 1]"),
              testing::HasSubstr("the edge from [2, 1] to [1, 0] crosses or touches the edge from [0, 0] to [2, 0]"));
  EXPECT_THAT(polygon_mistakes("[0, 0], [2, 0], [1, 0], [1, 1]"),
              testing::HasSubstr("the edge from [2, 0] to [1, 0] runs back over the edge from [0, 0] to [2, 0]"));
  EXPECT_THAT(polygon_mistakes("[0, 0], [1, 0], [2, 0]"), testing::HasSubstr("runs back over")) << "no area";
}

TEST(IdealDeck, RefusesListenersBehindTheWall) {
  EXPECT_EQ(
      ideal_mistakes(drum, "  ear: {type: mono, position: [0, 0, -1]}\n"),
      "deck.yaml:5:3: listeners.ear: hears nothing of body 'drum', which sounds in front of its wall only: the z of "
      "its position must be above 0 m");
  EXPECT_THAT(ideal_mistakes(drum, "  ear: {type: mono, position: [0, 0, 0]}\n"), testing::HasSubstr("hears nothing"));
  const std::string raised = "  bar: {type: bar, length: 1, width: 1, stiffness: 1, density: 1, position: [0, 0, 2]}\n";
  EXPECT_THAT(ideal_mistakes(drum + raised, ear), testing::HasSubstr("body 'bar'"));
}

}  // namespace
}  // namespace idiophone::sound_maps
