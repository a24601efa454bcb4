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

TEST_F(Materials, HaveALossFactorInABand) {
  const auto damping = [&](const std::string& keys) {
    return material("materials: {mine: {from: steel, damping: {" + keys + "}}}\n", "mine").damping;
  };
  EXPECT_FALSE(damping("mass: 1").loss);
  EXPECT_FALSE(damping("loss_factor: 0").loss);
  const LossFactor all = *damping("loss_factor: 0.01").loss;
  EXPECT_EQ(all.value, 0.01);
  EXPECT_EQ(all.band, (std::array{20.0, 20000.0}));
  EXPECT_FALSE(all.mechanisms);
  EXPECT_EQ(damping("loss_factor: table").loss->value, 2e-4);
  EXPECT_FALSE(material("", "steel").damping.loss) << "it costs time";
  EXPECT_FALSE(material("materials: {mine: {from: steel}}\n", "mine").damping.loss);
  const Damping some = damping("loss_factor: 0.01, band: [100, 5e3], mechanisms: 4, stiffness: 1e-9");
  EXPECT_EQ(some.loss->band, (std::array{100.0, 5000.0}));
  EXPECT_EQ(some.loss->mechanisms, 4);
  EXPECT_EQ(some.stiffness, 1e-9);
}

TEST_F(Materials, MistakesInALossFactorAreAnswered) {
  const auto answer = [&](const std::string& keys) {
    return mistakes(deck("materials:\n  mine: {from: steel, damping: {" + keys + "}}\n", "mine"));
  };
  EXPECT_EQ(answer("loss_factor: 0.4"),
            "deck.yaml:4:46: materials.mine.damping.loss_factor: must be at least 0 and at most 0.3, found 0.4");
  EXPECT_EQ(answer("loss_factor: 0.1, band: [20]"),
            "deck.yaml:4:57: materials.mine.damping.band: expected a list of 2 numbers (Hz), e.g. [20, 20000], found a "
            "list of 1");
  EXPECT_EQ(answer("loss_factor: 0.1, band: [20, 20]"),
            "deck.yaml:4:57: materials.mine.damping.band: must ascend, found 20 and 20");
  EXPECT_EQ(answer("loss_factor: 0.1, band: [0, 20]"),
            "deck.yaml:4:58: materials.mine.damping.band.0: must be at least 0.001 and at most 1000000 Hz, found 0");
  EXPECT_EQ(answer("loss_factor: 0.1, mechanisms: 13"),
            "deck.yaml:4:63: materials.mine.damping.mechanisms: must be at least 1 and at most 12, found 13");
  EXPECT_EQ(
      mistakes(
          deck("materials:\n  mine: {young: 1e9, poisson: 0, density: 1000, damping: {loss_factor: table}}\n", "mine")),
      "deck.yaml:4:59: materials.mine.damping.loss_factor: can't be that of the table: the material starts `from` "
      "none that is in it");
  EXPECT_EQ(answer("band: [20, 200], mechanisms: 3"),
            "deck.yaml:4:33: materials.mine.damping.band: has no meaning without a loss_factor\n"
            "deck.yaml:4:50: materials.mine.damping.mechanisms: has no meaning without a loss_factor");
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
    ASSERT_EQ(row.size(), 6U) << material.name;
    EXPECT_DOUBLE_EQ(std::stod(row[0]) * 1e9, material.young) << material.name;
    EXPECT_DOUBLE_EQ(std::stod(row[1]), material.poisson) << material.name;
    EXPECT_DOUBLE_EQ(std::stod(row[2]), material.density) << material.name;
    EXPECT_DOUBLE_EQ(std::stod(row[3]), material.damping.loss->value) << material.name;
    EXPECT_NE(row.back(), "") << material.name << " has no source";
  }
}

}  // namespace idiophone::scene
