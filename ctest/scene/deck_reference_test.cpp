// docs/deck.md and the program know the same keys, and what the page shows is so.

#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "deck_fixture.hpp"

namespace idiophone::scene {

class DeckReference : public DeckTest {
 protected:
  static std::string page() {
    std::ifstream file(IDIOPHONE_SOURCE_DIR "/docs/deck.md");
    return {std::istreambuf_iterator<char>(file), {}};
  }

  /// The n-th block of text fenced by ``` lines, counted from 0.
  static std::string block(std::size_t n) {
    static const std::regex fenced("```[a-z]*\n([^`]*)```\n");
    const std::string text = page();
    return std::next(std::sregex_iterator(text.begin(), text.end(), fenced), static_cast<std::ptrdiff_t>(n))->str(1);
  }

  /// The keys of each "## section", from the first column of its table.
  static std::map<std::string, std::set<std::string>> documented_keys() {
    static const std::regex row(R"(\| (\*\*)?`(\w+)`(\*\*)? \|.*)");
    std::map<std::string, std::set<std::string>> keys;
    std::istringstream lines(page());
    std::string section;
    for (std::string line; std::getline(lines, line);) {
      std::smatch match;
      if (line.starts_with("## ")) {
        section = line.substr(3);
      }
      if (std::regex_match(line, match, row)) {
        keys[section].insert(match[2]);
      }
    }
    return keys;
  }

  /// The keys that the program names when it meets an unknown one in the section at the path.
  [[nodiscard]] std::set<std::string> known_keys(const std::string& path) const {
    static const std::regex list("unknown key, known here: ([a-z_, ]+)");
    const std::string answer =
        mistakes(whole, {(path.empty() ? "" : path + ".") + "qqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqq=0"});
    std::smatch match;
    EXPECT_TRUE(std::regex_search(answer, match, list)) << answer;
    std::string keys = match[1];
    std::erase(keys, ',');
    std::istringstream words(keys);
    return {std::istream_iterator<std::string>(words), {}};
  }

  const std::string whole =
      replaced(replaced(replaced(plate, "material: steel", "material: spruce, grain: {x: [1, 0, 0], y: [0, 1, 0]}"),
                        "fixed: [rim]",
                        "fixed: [{group: rim}],"
                        " driven: [{group: top, displacement: [0, 0, 1], duration: 1,"
                        " rotation: {axis: [1, 0, 0], degrees: 1, pivot: [0, 0, 0]}}],"
                        " element: hex, order: {plane: 3, thickness: 2}, mass_scaling: {shift: 2},"
                        " supports: {cord: {at: [0, 0, 0], stiffness: 1}},"
                        " rotation: {axis: [1, 0, 0], degrees: 1}"),
               "loads:\n", "loads:\n  pull: {type: pluck, at: [0, 0, 0], force: [0, 0, 1]}\n") +
      "  ears: {type: stereo, position: [0, 0, 1], look: [0, 0, -1], up: [0, 1, 0]}\n"
      "  head: {type: binaural, position: [0, 0, 1], look: [0, 0, -1], up: [0, 1, 0]}\n"
      "obstacles:\n"
      "  floor: {shape: half_space, at: [0, 0, 0]}\n"
      "  block: {shape: box, at: [0, 0, 0], size: [1, 1, 1],"
      " rotation: {axis: [1, 0, 0], degrees: 1}}\n"
      "  ball: {shape: sphere, at: [0, 0, 0], radius: 1}\n"
      "  post: {shape: cylinder, at: [0, 0, 0], radius: 1, length: 1}\n"
      "  rock: {shape: surface, at: [0, 0, 0], mesh: plate.geo}\n"
      "contacts: {bounce: {between: [plate, floor], friction: {sticking: 1, sliding: 1}}}\n"
      "radiation: {floor: {at: [0, 0, -1]}}\n";

  const std::map<std::string, std::string> paths = {
      {"deck", ""},
      {"time", "time"},
      {"materials.NAME", "materials.steel"},
      {"materials.NAME.damping", "materials.steel.damping"},
      {"bodies.NAME", "bodies.plate"},
      {"bodies.NAME.grain", "bodies.plate.grain"},
      {"bodies.NAME.order", "bodies.plate.order"},
      {"bodies.NAME.mass_scaling", "bodies.plate.mass_scaling"},
      {"bodies.NAME.fixed.INDEX", "bodies.plate.fixed.0"},
      {"bodies.NAME.driven.INDEX", "bodies.plate.driven.0"},
      {"bodies.NAME.driven.INDEX.rotation", "bodies.plate.driven.0.rotation"},
      {"bodies.NAME.supports.NAME", "bodies.plate.supports.cord"},
      {"obstacles.NAME, shape: half_space", "obstacles.floor"},
      {"obstacles.NAME, shape: box", "obstacles.block"},
      {"obstacles.NAME.rotation", "obstacles.block.rotation"},
      {"obstacles.NAME, shape: sphere", "obstacles.ball"},
      {"obstacles.NAME, shape: cylinder", "obstacles.post"},
      {"obstacles.NAME, shape: surface", "obstacles.rock"},
      {"contacts.NAME", "contacts.bounce"},
      {"contacts.NAME.friction", "contacts.bounce.friction"},
      {"loads.NAME, type: pulse", "loads.tap"},
      {"loads.NAME, type: pluck", "loads.pull"},
      {"listeners.NAME, type: mono", "listeners.ear"},
      {"listeners.NAME, type: stereo", "listeners.ears"},
      {"listeners.NAME, type: binaural", "listeners.head"},
      {"audio", "audio"},
      {"radiation", "radiation"},
      {"radiation.visibility", "radiation.visibility"},
      {"radiation.air", "radiation.air"},
      {"radiation.floor", "radiation.floor"},
      {"output", "output"},
      {"output.checkpoint", "output.checkpoint"}};
};

TEST_F(DeckReference, DocumentsTheKeysThatThereAre) {
  const auto documented = documented_keys();
  for (const auto& [section, path] : paths) {
    ASSERT_TRUE(documented.contains(section)) << section;
    EXPECT_EQ(documented.at(section), known_keys(path)) << section;
  }
  EXPECT_EQ(documented.size(), paths.size());
}

TEST_F(DeckReference, ShowsADeckThatIsRight) {
  write("square_plate.geo", "");
  const Scene scene = read(block(0));
  EXPECT_EQ(scene.name, "square_plate");
  EXPECT_EQ(scene.bodies.at(0).parameters.at("thickness"), 0.003);
  EXPECT_EQ(scene.listeners.at(0).receivers.size(), 2U);
}

TEST_F(DeckReference, ShowsAnswersAsTheyAre) {
  const std::string deck = replaced(replaced(block(0), "{young", "{yuong"), "mesh: square", "mesh: sqare");
  EXPECT_EQ(replaced(replaced(mistakes(deck), "deck.yaml:", "plate.yaml:"), "DIR", "/home/ada") + "\n", block(1));
}

TEST_F(DeckReference, ShowsContactsAsTheyAre) {
  const Scene scene = read(plate + block(3));
  EXPECT_EQ(scene.obstacles.at(0).name, "floor");
  EXPECT_EQ(scene.contacts.at(0).friction.sliding, 0.3);
}

TEST_F(DeckReference, ShowsReferencesAsTheyAre) {
  const Scene scene = read(plate + block(4));
  EXPECT_EQ(scene.references.at(0).name, "thin plate (Leissa)");
  EXPECT_EQ(scene.references.at(0).frequencies.size(), 4U);
}

}  // namespace idiophone::scene
