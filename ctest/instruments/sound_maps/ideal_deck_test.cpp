// Mistakes in decks of ideal bodies.

#include "idiophone/instruments/sound_maps/ideal_deck.hpp"

#include <gmock/gmock.h>

#include <fstream>

#include "idiophone/foundation/deck/location.hpp"
#include "ranks.hpp"
#include "shared_folder.hpp"

namespace idiophone::sound_maps {
namespace {

const std::string drum_line =
    "  drum: {type: membrane, polygon: [[0, 0], [1, 0], [1, 1], [0, 1]], tension: 100, density: 1}\n";
const std::string ear_line = "  ear: {type: mono, position: [0, 0, 1]}\n";

/// The mistakes of a deck, a line each, without its folder.
/// @param points  of a file points.csv beside it
std::string ideal_mistakes(const std::string& bodies, const std::string& listeners, const std::string& points = "") {
  const support::Folder folder;
  const std::filesystem::path file = folder.path() / "deck.yaml";
  std::ofstream(folder.path() / "points.csv") << points;
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
  return ideal_mistakes("  drum: {type: membrane, tension: 100, density: 1, polygon: [" + polygon + "]}\n", ear_line);
}

/// Those of a square plate of side 4 with these keys besides.
std::string plate_mistakes(const std::string& keys) {
  return ideal_mistakes(
      "  plate: {type: plate, polygon: [[0, 0], [4, 0], [4, 4], [0, 4]], stiffness: 1, density: 1, " + keys + "}\n",
      ear_line);
}

/// Those of a disc of radius 1 that is a membrane with these keys besides.
std::string disc_mistakes(const std::string& keys) {
  return ideal_mistakes("  disc: {type: membrane, radius: 1, " + keys + "}\n", ear_line);
}

ON_RANKS(1);

TEST(IdealDeck, HasPolygonsEitherWayRound) {
  EXPECT_EQ(ideal_mistakes(drum_line, ear_line), "no mistakes");
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

TEST(IdealDeck, HasPlatesOfThreeKindsOfOutlines) {
  EXPECT_EQ(plate_mistakes("edges: [clamped, free, supported, free], poisson: 0.25"), "no mistakes");
  EXPECT_EQ(plate_mistakes("edges: free, holes: [{radius: 0.5, at: [2, 2], edges: clamped}]"), "no mistakes");
  EXPECT_EQ(plate_mistakes("length: 3"),
            "deck.yaml:3:93: ideal_bodies.plate.length: belongs to a rectangular plate, which has neither polygon nor "
            "radius");
  EXPECT_EQ(plate_mistakes("edges: [clamped, free]"),
            "deck.yaml:3:100: ideal_bodies.plate.edges: needs one word, or one for each of the 4 sides, from the first "
            "corner on; found a list of 2");
  EXPECT_THAT(plate_mistakes("edges: [clamped, free, fixed, free]"), testing::HasSubstr("must be one of free"));
  EXPECT_THAT(plate_mistakes("tension: 5, edges: [clamped, free, supported, free]"),
              testing::HasSubstr("tension: needs edges that are supported or clamped"));
  EXPECT_THAT(ideal_mistakes("  plate: {type: plate, stiffness: 1, density: 1, length: 2}\n", ear_line),
              testing::HasSubstr("the key 'width' is missing"));
  EXPECT_EQ(ideal_mistakes("  plate: {type: plate, stiffness: 1, density: 1, radius: 2, edges: free}\n", ear_line),
            "no mistakes");
}

TEST(IdealDeck, LimitsTheNumberOfElements) {
  EXPECT_EQ(disc_mistakes("tension: 1, density: 1, size: 0.004"), "no mistakes");
  EXPECT_THAT(
      disc_mistakes("tension: 1, density: 1, size: 0.003"),
      testing::HasSubstr("disc.size: makes more than 500 elements along the diameter; the least size is 0.004 m"));
}

TEST(IdealDeck, NamesHolesThatReachTheOutlineOrMeet) {
  EXPECT_EQ(
      plate_mistakes("holes: [{radius: 1, at: [1, 2]}]"),
      "deck.yaml:3:101: ideal_bodies.plate.holes.0: this hole is not inside the outline: it must leave a rim around "
      "it");
  EXPECT_THAT(plate_mistakes("holes: [{radius: 1, at: [7, 2]}]"), testing::HasSubstr("not inside the outline"));
  EXPECT_THAT(plate_mistakes("holes: [{polygon: [[1, 1], [3, 1], [2, 4]]}]"),
              testing::HasSubstr("not inside the outline"));
  EXPECT_EQ(plate_mistakes("holes: [{radius: 1, at: [1.5, 2]}, {polygon: [[3, 2], [3.5, 2], [3.5, 3]]}]"),
            "no mistakes");
  EXPECT_THAT(plate_mistakes("holes: [{radius: 1, at: [1.5, 2]}, {polygon: [[2, 2], [3, 2], [3, 3]]}]"),
              testing::HasSubstr("holes.1: this hole meets hole 1"));
  EXPECT_THAT(plate_mistakes("holes: [{radius: 1, at: [2, 2]}, {radius: 0.2, at: [2, 2]}]"),
              testing::HasSubstr("meets hole 1"))
      << "one inside the other";
  EXPECT_THAT(plate_mistakes("holes: [{polygon: [[1, 1], [2, 2], [2, 1], [1, 2]]}]"),
              testing::HasSubstr("crosses or touches"));
  EXPECT_THAT(disc_mistakes("tension: 1, density: 1, holes: [{radius: 0.5, at: [0.5, 0]}]"),
              testing::HasSubstr("not inside the outline"));
  EXPECT_THAT(plate_mistakes("holes: [{radius: 1e-4, at: [2, 2]}]"),
              testing::HasSubstr("smaller than a ten-thousandth"));
  EXPECT_THAT(disc_mistakes("tension: 1, density: 1, holes: [{radius: 0.5, edges: free}]"),
              testing::HasSubstr("a membrane is held at its holes"));
}

TEST(IdealDeck, HasFormulasOfXAndY) {
  EXPECT_EQ(disc_mistakes("tension: 100*(1 + x^2), density: '0.2 + 0.1*cos(2*pi*y)'"), "no mistakes");
  EXPECT_EQ(
      disc_mistakes("tension: 100*(1 + z), density: 1"),
      "deck.yaml:3:46: ideal_bodies.disc.tension: expected a number or a formula of x and y, such as 0.2*(1 + x^2): "
      "Unexpected token \"z\" found at position 9.");
  EXPECT_THAT(disc_mistakes("tension: 1, density: 'x = 3'"), testing::HasSubstr("a formula has no sign '='"));
  EXPECT_THAT(disc_mistakes("tension: 1, density: '1, 5'"), testing::HasSubstr("the formula has several values"));
  EXPECT_THAT(disc_mistakes("tension: 1, density: -1"), testing::HasSubstr("density: must be")) << "a number";
  EXPECT_THAT(disc_mistakes("tension: 1, density: [1]"), testing::HasSubstr("density.0: expected a list of 3 numbers"));
  EXPECT_THAT(disc_mistakes("tension: 1, density: [[0, 0, -2]]"), testing::HasSubstr("with a value above 0"));
  EXPECT_THAT(disc_mistakes("tension: 1, density: []"), testing::HasSubstr("is empty"));
}

TEST(IdealDeck, TakesTheDensityOfAMembraneFromAFileOfPoints) {
  const auto mistakes = [](const std::string& points, const std::string& file = "points.csv") {
    return ideal_mistakes("  disc: {type: membrane, radius: 1, tension: 1, density: " + file + "}\n", ear_line, points);
  };
  EXPECT_EQ(mistakes("# x, y, kg/m2\n0, 0, 0.2\n1, 0, 0.3\n"), "no mistakes");
  EXPECT_EQ(mistakes("0, 0, 0.2\n1, 0, -2\n"),
            "points.csv:2:1: expected [x, y, value] with a value above 0 and at most 1000000 kg/m or kg/m2");
  EXPECT_EQ(mistakes("0, 0\n"), "points.csv:1:5: expected a comma between y and value, found ''");
  EXPECT_THAT(mistakes("# nothing\n"), testing::HasSubstr("density: is empty"));
  EXPECT_THAT(mistakes("", "other.csv"), testing::HasSubstr("density: no such file:"));
  std::string many;
  for (int row = 0; row < 1001; ++row) {
    many += std::to_string(row) + ", 0, 1\n";
  }
  EXPECT_THAT(mistakes(many), testing::HasSubstr("has 1001 points; at most 1000"));
}

TEST(IdealDeck, ReadsTheRowsOfAFileOfPoints) {
  const support::Folder folder;
  std::ofstream(folder.path() / "tension.csv") << "0, 0, 100\n0.5, -1, 300\n";
  std::ofstream(folder.path() / "deck.yaml") << "name: ideal\nideal_bodies:\n  disc: {type: membrane, radius: 1, "
                                                "tension: tension.csv, density: 1}\nlisteners:\n"
                                             << ear_line;
  const IdealBody body = read_ideal_deck(folder.path() / "deck.yaml", {}).bodies.front();
  EXPECT_THAT(body.tension_points, testing::ElementsAre(Vector3(0, 0, 100), Vector3(0.5, -1, 300)));
  EXPECT_TRUE(body.tension_formula.empty());
}

TEST(IdealDeck, RefusesListenersBehindTheWall) {
  EXPECT_EQ(
      ideal_mistakes(drum_line, "  ear: {type: mono, position: [0, 0, -1]}\n"),
      "deck.yaml:5:3: listeners.ear: hears nothing of body 'drum', which sounds in front of its wall only: the z of "
      "its position must be above 0 m");
  EXPECT_THAT(ideal_mistakes(drum_line, "  ear: {type: mono, position: [0, 0, 0]}\n"),
              testing::HasSubstr("hears nothing"));
  const std::string raised = "  bar: {type: bar, length: 1, width: 1, stiffness: 1, density: 1, position: [0, 0, 2]}\n";
  EXPECT_THAT(ideal_mistakes(drum_line + raised, ear_line), testing::HasSubstr("body 'bar'"));
}

}  // namespace
}  // namespace idiophone::sound_maps
