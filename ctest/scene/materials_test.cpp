// Materials that come with the program: by name, as a start for the deck's own, and as docs/materials.md shows them.

#include "idiophone/scene/shipped_materials.hpp"

#include <map>
#include <regex>
#include <sstream>

#include "deck_fixture.hpp"

namespace idiophone::scene {

class Materials : public DeckTest {
 protected:
  /// The small deck with another map of materials, and its body made of `name`.
  [[nodiscard]] std::string deck(const std::string& materials, const std::string& name) const {
    return replaced(replaced(plate, "materials:\n  steel: {young: 2.0e11, poisson: 0.3, density: 7850}\n", materials),
                    "material: steel", "material: " + name);
  }
  [[nodiscard]] Material material(const std::string& materials, const std::string& name) const {
    const Scene scene = read(deck(materials, name));
    return scene.materials.at(scene.bodies.at(0).material);
  }
};

TEST_F(Materials, ThatComeWithTheProgramNeedNoEntry) {
  const Material brass = material("", "brass");
  EXPECT_EQ(brass.name, "brass");
  EXPECT_EQ(brass.young, 100.6e9);
  EXPECT_EQ(brass.density, 8500);
}

TEST_F(Materials, StartFromOneThatComesWithTheProgram) {
  const Material heavy = material("materials: {heavy: {from: brass, density: 9000, damping: {mass: 3}}}\n", "heavy");
  EXPECT_EQ(heavy.name, "heavy");
  EXPECT_EQ(heavy.young, 100.6e9);
  EXPECT_EQ(heavy.poisson, 0.35);
  EXPECT_EQ(heavy.density, 9000);
  EXPECT_EQ(heavy.damping.mass, 3);
  EXPECT_EQ(heavy.where.line, 3U);
}

TEST_F(Materials, OfTheDeckTakeThePlaceOfThoseOfTheSameName) {
  EXPECT_EQ(material("materials: {brass: {young: 1e11, poisson: 0.3, density: 8000}}\n", "brass").density, 8000);
  EXPECT_EQ(material("materials: {brass: {from: brass, young: 1e11}}\n", "brass").density, 8500);
}

TEST_F(Materials, MistakesAreAnswered) {
  EXPECT_THAT(
      mistakes(deck("materials: {old: {from: stel}}\n", "old")),
      testing::AllOf(testing::StartsWith("deck.yaml:3:25: materials.old.from: must be one of steel, aluminium,"),
                     testing::EndsWith(", found 'stel' (did you mean 'steel'?)")));
  EXPECT_EQ(mistakes(deck("materials: {old: {from: steel, density: -1}}\n", "old")),
            "deck.yaml:3:41: materials.old.density: must be above 0 and at most 1000000 kg/m3, found -1");
  EXPECT_THAT(mistakes(deck("materials: {old: {from: steel}}\n", "od")),
              testing::AllOf(testing::HasSubstr("bodies.plate.material: must be one of old, steel, aluminium,"),
                             testing::EndsWith("found 'od' (did you mean 'old'?)")));
}

/// Rows of docs/materials.md: name -> numbers of the columns after it, in the page's units.
std::map<std::string, std::vector<std::string>> page() {
  static const std::regex name(R"(\| `(\w+)` \|(.*)\|)");
  std::ifstream file(IDIOPHONE_SOURCE_DIR "/docs/materials.md");
  std::map<std::string, std::vector<std::string>> rows;
  for (std::string line; std::getline(file, line);) {
    std::smatch match;
    if (std::regex_match(line, match, name)) {
      std::istringstream cells(match[2]);
      for (std::string cell; std::getline(cells, cell, '|');) {
        rows[match[1]].push_back(std::regex_replace(cell, std::regex("^ +| +$"), ""));
      }
    }
  }
  return rows;
}

TEST(ShippedMaterials, AreThoseOfThePage) {
  const auto rows = page();
  EXPECT_EQ(rows.size(), shipped_materials().size());
  for (const Material& material : shipped_materials()) {
    ASSERT_TRUE(rows.contains(material.name)) << material.name;
    const std::vector<std::string>& row = rows.at(material.name);
    ASSERT_EQ(row.size(), 5U) << material.name;
    EXPECT_DOUBLE_EQ(std::stod(row[0]) * 1e9, material.young) << material.name;
    EXPECT_DOUBLE_EQ(std::stod(row[1]), material.poisson) << material.name;
    EXPECT_DOUBLE_EQ(std::stod(row[2]), material.density) << material.name;
    EXPECT_NE(row.back(), "") << material.name << " has no source";
  }
}

}  // namespace idiophone::scene
