// Materials that come with the program: by name, as a start for the deck's own, and as docs/use/materials.md shows
// them.

#include "shipped_materials.hpp"

#include <map>
#include <regex>
#include <sstream>

#include "deck_fixture.hpp"
#include "idiophone/scene/body_materials.hpp"

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

TEST_F(Materials, WithoutDampingLetBodiesRing) {
  for (const auto& [damping, rings] : std::map<std::string, bool>{{"{}", true},
                                                                  {"{mass: 3}", false},
                                                                  {"{stiffness: 1e-8}", false},
                                                                  {"{loss_factor: table}", false},
                                                                  {"{loss_factor: 0}", true}}) {
    const Scene scene = read(deck("materials: {own: {from: brass, damping: " + damping + "}}\n", "own"));
    EXPECT_EQ(is_undamped(scene.bodies.at(0), scene.materials), rings) << damping;
  }
}

TEST_F(Materials, OfTheDeckTakeThePlaceOfThoseOfTheSameName) {
  EXPECT_EQ(material("materials: {brass: {young: 1e11, poisson: 0.3, density: 8000}}\n", "brass").density, 8000);
  EXPECT_EQ(material("materials: {brass: {from: brass, young: 1e11}}\n", "brass").density, 8500);
}

TEST_F(Materials, AreOrthotropic) {
  const std::string ply =
      "materials: {ply: {young: [9e9, 5e9, 1e9], poisson: [0.1, 0.3, 0.2], shear: [7e8, 3e8, 2e8], density: 550}}\n";
  const Material own = material(ply, "ply");
  EXPECT_EQ(own.young, 9e9);
  EXPECT_EQ(own.orthotropy->young, Vector3(9e9, 5e9, 1e9));
  EXPECT_EQ(own.orthotropy->poisson, Vector3(0.1, 0.3, 0.2));
  EXPECT_EQ(own.orthotropy->shear, Vector3(7e8, 3e8, 2e8));
  const Material stiff = material("materials: {stiff: {from: spruce, young: [15e9, 1e9, 6e8]}}\n", "stiff");
  EXPECT_EQ(stiff.young, 15e9);
  EXPECT_EQ(stiff.orthotropy->young, Vector3(15e9, 1e9, 6e8));
  EXPECT_EQ(stiff.orthotropy->shear, material("", "spruce").orthotropy->shear);
  EXPECT_FALSE(material("", "steel").orthotropy);
}

TEST_F(Materials, AxesAreTheMeshsOwnAndTurnWithIt) {
  const auto body = [&](const std::string& keys) { return read(deck("", "spruce" + keys)).bodies.at(0); };
  EXPECT_EQ(body("").material_axes(), Eigen::Matrix3d::Identity());
  const Eigen::Matrix3d upright = body(", grain: {x: [0, 0, 2], y: [1, 1, 0]}").material_axes();
  const double half = std::sqrt(0.5);
  EXPECT_LT((upright.col(0) - Vector3(0, 0, 1)).norm(), 1e-15);
  EXPECT_LT((upright.col(1) - Vector3(half, half, 0)).norm(), 1e-15);
  EXPECT_LT((upright.col(2) - Vector3(-half, half, 0)).norm(), 1e-15);
  const Eigen::Matrix3d turned =
      body(", grain: {x: [0, 1, 0], y: [0, 0, 1]}, rotation: {axis: [0, 0, 1], degrees: 90}").material_axes();
  EXPECT_LT((turned.col(0) - Vector3(-1, 0, 0)).norm(), 1e-15);
  EXPECT_LT((turned.col(1) - Vector3(0, 0, 1)).norm(), 1e-15);
  EXPECT_LT((turned.col(2) - Vector3(0, 1, 0)).norm(), 1e-15);
}

TEST_F(Materials, AShippedOneWithoutConstantsIsToldHowToTakeThem) {
  EXPECT_EQ(mistakes(deck("materials:\n  steel: {damping: {loss_factor: 0.004}}\n", "steel")),
            "deck.yaml:4:10: materials.steel: no constants; 'from: steel' takes those of the shipped material");
}

TEST_F(Materials, MistakesInOrthotropyAreAnswered) {
  const auto answer = [&](const std::string& keys) { return mistakes(deck("materials:\n  a: {" + keys + "}\n", "a")); };
  EXPECT_EQ(answer("young: [9, 5, 1], poisson: 0.3, density: 550"),
            "deck.yaml:4:6: materials.a: the key 'shear' is missing\n"
            "deck.yaml:4:34: materials.a.poisson: expected a list of 3 numbers, e.g. [0, 0, 1], found '0.3'");
  EXPECT_EQ(answer("from: steel, shear: [1, 2, 3]"),
            "deck.yaml:4:6: materials.a: the key 'young' is missing\n"
            "deck.yaml:4:6: materials.a: the key 'poisson' is missing");
  EXPECT_EQ(answer("from: spruce, young: 1e9"),
            "deck.yaml:4:28: materials.a.young: expected a list of 3 numbers (Pa), e.g. [0, 0, 1], found '1e9'");
  EXPECT_EQ(
      answer("from: spruce, poisson: [0.1, 2, 0.1]"),
      "deck.yaml:4:30: materials.a.poisson: yz must be above -1.346 and below 1.346, sqrt(E_y/E_z), found 2: such a "
      "material would gain energy by being strained");
  EXPECT_THAT(
      answer("young: [1, 1, 1], poisson: [0.6, 0.6, 0.6], shear: [1, 1, 1], density: 1"),
      testing::AllOf(testing::StartsWith("deck.yaml:4:34: materials.a.poisson: the three together are too large"),
                     testing::HasSubstr("must be at least 0.0001, and is -0.512: ")));
  EXPECT_EQ(mistakes(deck("", "steel, grain: {x: [1, 0, 0], y: [0, 1, 0]}")),
            "deck.yaml:4:45: bodies.plate.grain: has no meaning: 'steel' is isotropic");
  EXPECT_EQ(mistakes(deck("", "spruce, grain: {x: [1, 0, 0], y: [1, 1, 0]}")),
            "deck.yaml:4:53: bodies.plate.grain: x and y must be at right angles, found 45 degrees");
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

TEST_F(Materials, HaveALossFactorOverTheFrequency) {
  const std::string keys = "loss_factor: [[100, 0.01], [1000, 0.04], [4000, 0.02]]";
  const LossFactor loss = *material("materials: {mine: {from: steel, damping: {" + keys + "}}}\n", "mine").damping.loss;
  EXPECT_EQ(loss.value, 0.04);
  EXPECT_EQ(loss.band, (std::array{100.0, 4000.0}));
  EXPECT_EQ(loss.at(1000), 0.04);
  EXPECT_NEAR(loss.at(std::sqrt(1e5)), 0.02, 1e-15);
  EXPECT_EQ(loss.at(50), 0.01);
  EXPECT_EQ(loss.at(5000), 0.02);
}

TEST_F(Materials, HaveLossFactorsByDirection) {
  const std::string keys = "loss_factor: {young: [0.005, 0.02, 0.03], shear: [0.016, 0.04, 0.01]}, band: [50, 5000]";
  const LossFactor loss =
      *material("materials: {mine: {from: spruce, damping: {" + keys + "}}}\n", "mine").damping.loss;
  EXPECT_EQ(loss.value, 0.04);
  EXPECT_EQ(loss.directions->young, Vector3(0.005, 0.02, 0.03));
  EXPECT_EQ(loss.directions->shear, Vector3(0.016, 0.04, 0.01));
  EXPECT_EQ(loss.band, (std::array{50.0, 5000.0}));
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
      "deck.yaml:4:59: materials.mine.damping.loss_factor: can't be 'table' without a shipped material; name one with "
      "the "
      "key from");
  EXPECT_EQ(
      answer("loss_factor: [[100, 0.01]]"),
      "deck.yaml:4:46: materials.mine.damping.loss_factor: give at least two points [frequency, loss factor], or a "
      "number");
  EXPECT_EQ(answer("loss_factor: [[100, 0.01], [50, 0.02]]"),
            "deck.yaml:4:46: materials.mine.damping.loss_factor: the frequencies of the points must ascend");
  EXPECT_EQ(answer("loss_factor: [[100, 0.01], 0.02]"),
            "deck.yaml:4:60: materials.mine.damping.loss_factor.1: expected [frequency, loss factor], found '0.02'");
  EXPECT_EQ(
      answer("loss_factor: [[100, 0.01], [500, 0.02]], band: [100, 500]"),
      "deck.yaml:4:74: materials.mine.damping.band: has no meaning with a loss_factor over the frequency: its band "
      "is that of the points");
  EXPECT_EQ(answer("loss_factor: {young: [0.1, 0.1, 0.1], shear: [0.1, 0.1, 0.1]}"),
            "deck.yaml:4:32: materials.mine.damping: loss_factor by direction needs a material with young, poisson and "
            "shear by direction");
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
            "deck.yaml:3:41: materials.old.density: must be at least 0.001 and at most 1000000 kg/m3, found -1");
  EXPECT_THAT(mistakes(deck("materials: {old: {from: steel}}\n", "od")),
              testing::AllOf(testing::HasSubstr("bodies.plate.material: must be one of old, steel, aluminium,"),
                             testing::EndsWith("found 'od' (did you mean 'old'?)")));
}

/// Rows of docs/use/materials.md: name -> numbers of the columns after it, in the page's units.
std::map<std::string, std::vector<std::string>> page() {
  static const std::regex name(R"(\| `(\w+)` \|(.*)\|)");
  std::ifstream file(IDIOPHONE_SOURCE_DIR "/docs/use/materials.md");
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

/// "1.5, 2, 3" as numbers.
std::vector<double> numbers(const std::string& cell) {
  std::vector<double> found;
  std::istringstream parts(cell);
  for (std::string part; std::getline(parts, part, ',');) {
    found.push_back(std::stod(part));
  }
  return found;
}

/// The cells before the last two ("what it is" and "source"), in the page's units.
std::vector<std::vector<double>> cells(const Material& material) {
  const std::vector<double> density = {material.density};
  const std::vector<double> loss = {material.damping.loss->value};
  if (!material.orthotropy) {
    return {{material.young / 1e9}, {material.poisson}, density, loss};
  }
  const auto& [young, poisson, shear] = *material.orthotropy;
  const auto list = [](const Vector3& three) { return std::vector<double>(three.begin(), three.end()); };
  return {list(young / 1e9), list(poisson), list(shear / 1e9), density, loss};
}

TEST(ShippedMaterials, AreThoseOfThePage) {
  const auto rows = page();
  EXPECT_EQ(rows.size(), shipped_materials().size());
  for (const Material& material : shipped_materials()) {
    ASSERT_TRUE(rows.contains(material.name)) << material.name;
    const std::vector<std::string>& row = rows.at(material.name);
    const auto expected = cells(material);
    ASSERT_EQ(row.size(), expected.size() + 2) << material.name;
    for (std::size_t cell = 0; cell < expected.size(); ++cell) {
      EXPECT_THAT(numbers(row[cell]), testing::Pointwise(testing::DoubleEq(), expected[cell])) << material.name;
    }
    EXPECT_NE(row.back(), "") << material.name << " has no source";
  }
}

}  // namespace idiophone::scene
