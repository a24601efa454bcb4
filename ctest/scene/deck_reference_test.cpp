// docs/use/deck.md and the program know the same keys, and what the page shows is so.

#include <set>

#include "deck_fixture.hpp"
#include "every_key.hpp"

namespace idiophone::scene {

class DeckReference : public DeckTest {
 protected:
  /// The n-th block of text fenced by ``` lines, counted from 0.
  static std::string block(std::size_t n) {
    static const std::regex fenced("```[a-z]*\n([^`]*)```\n");
    const std::string text = deck_page();
    return std::next(std::sregex_iterator(text.begin(), text.end(), fenced), static_cast<std::ptrdiff_t>(n))->str(1);
  }

  /// The keys that the program names when it meets an unknown one in the section at the path.
  [[nodiscard]] std::set<std::string> known_keys(const std::string& path) const {
    static const std::regex list("unknown key, known here: ([a-z_, ]+)");
    const std::string answer = mistakes(
        every_key_at(plate, path), {(path.empty() ? "" : path + ".") + "qqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqq=0"});
    std::smatch match;
    EXPECT_TRUE(std::regex_search(answer, match, list)) << answer;
    std::string keys = match[1];
    std::erase(keys, ',');
    std::istringstream words(keys);
    return {std::istream_iterator<std::string>(words), {}};
  }
};

TEST_F(DeckReference, DocumentsTheKeysThatThereAre) {
  const auto documented = documented_keys();
  for (const auto& [section, path] : every_path()) {
    ASSERT_TRUE(documented.contains(section)) << section;
    std::set<std::string> keys;
    for (const auto& [key, has_default] : documented.at(section)) {
      keys.insert(key);
    }
    EXPECT_EQ(keys, known_keys(path)) << section;
  }
  EXPECT_EQ(documented.size(), every_path().size());
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

TEST_F(DeckReference, ShowsBowsAsTheyAre) {
  const Scene scene = read(replaced(plate, "loads:\n", block(4)));
  EXPECT_EQ(scene.bows.at(0).load_at(1.0), 2.0);
}

TEST_F(DeckReference, ShowsGaugesAsTheyAre) {
  const Scene scene = read(plate + block(5));
  EXPECT_EQ(scene.gauges.at(0).quantity, Gauge::Quantity::curvature);
  EXPECT_EQ(scene.gauges.at(0).points.size(), 3U);
}

TEST_F(DeckReference, ShowsReferencesAsTheyAre) {
  const Scene scene = read(plate + block(6));
  EXPECT_EQ(scene.references.at(0).name, "thin plate (Leissa)");
  EXPECT_EQ(scene.references.at(0).frequencies.size(), 4U);
}

}  // namespace idiophone::scene
