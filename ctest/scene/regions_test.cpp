// Bodies of several materials in a deck, and mistakes.

#include "deck_fixture.hpp"
#include "idiophone/scene/resolved_deck.hpp"

namespace idiophone::scene {
namespace {

class Regions : public DeckTest {
 protected:
  /// The small deck with these keys of the body in the place of its material.
  [[nodiscard]] std::string deck(const std::string& keys, const std::string& materials = "") const {
    return replaced(replaced(plate, "density: 7850}\n", "density: 7850}\n" + materials), "material: steel", keys);
  }
  [[nodiscard]] Body body(const std::string& keys) const { return read(deck(keys)).bodies.at(0); }
};

TEST_F(Regions, AreNamedByTheGroupsOfTheMesh) {
  const Scene scene =
      read(deck("materials: {the core: steel, head: {material: spruce, grain: {x: [0, 1, 0], y: [0, 0, 1]}}}"));
  const std::vector<MaterialRegion>& regions = scene.bodies.at(0).regions;
  ASSERT_EQ(regions.size(), 2U);
  EXPECT_EQ(regions[0].name, "the core");
  EXPECT_EQ(scene.materials.at(regions[0].material).name, "steel");
  EXPECT_EQ(scene.materials.at(regions[1].material).name, "spruce");
  EXPECT_EQ(regions[1].grain.col(2), Vector3(1, 0, 0));
  EXPECT_EQ(scene.bodies.at(0).material, regions[0].material);
  EXPECT_FALSE(scene.bodies.at(0).has_layers());
}

TEST_F(Regions, OrLayersOfAWall) {
  const Body wall = body(
      "element: hex, layers: [{material: steel, thickness: 0.001}, {material: spruce, thickness: 0.002, grain: {x: [1, "
      "0, 0], y: [0, 1, 0]}}]");
  ASSERT_EQ(wall.regions.size(), 2U);
  EXPECT_TRUE(wall.has_layers());
  EXPECT_EQ(wall.thickness, 0.003);
  EXPECT_EQ(wall.regions[1].name, "2");
  EXPECT_EQ(wall.regions[1].thickness, 0.002);
}

TEST_F(Regions, OneMaterialIsOneRegion) {
  const Body whole = body("material: steel");
  EXPECT_TRUE(whole.regions.empty());
  ASSERT_EQ(whole.all_regions().size(), 1U);
  EXPECT_EQ(whole.all_regions()[0].material, whole.material);
}

TEST_F(Regions, StandInTheResolvedDeck) {
  write("deck.yaml", deck("materials: {core: steel, head: maple}"));
  EXPECT_THAT(resolved_deck(folder / "deck.yaml"),
              testing::HasSubstr("    materials:\n      core: steel\n      head: maple\n"));
}

TEST_F(Regions, MistakesAreAnswered) {
  const auto answer = [&](const std::string& keys, const std::string& materials = "") {
    return mistakes(deck(keys, materials));
  };
  EXPECT_THAT(answer("materials: {core: steel, head: steal}"),
              testing::AllOf(testing::StartsWith("deck.yaml:6:59: bodies.plate.materials.head: must be one of steel, "),
                             testing::HasSubstr("did you mean 'steel'?")));
  EXPECT_EQ(
      answer("materials: {}"),
      "deck.yaml:6:39: bodies.plate.materials: is empty; it needs a material for each group of the mesh's elements");
  EXPECT_EQ(
      answer("materials: steel"),
      "deck.yaml:6:39: bodies.plate.materials: expected a map from groups of the mesh to materials, found 'steel'");
  EXPECT_EQ(answer("materials: {core: {material: steel, grain: {x: [1, 0, 0], y: [0, 1, 0]}}}"),
            "deck.yaml:6:64: bodies.plate.materials.core.grain: has no meaning: 'steel' is isotropic");
  EXPECT_EQ(answer("material: steel, materials: {core: steel}"),
            "deck.yaml:6:28: bodies.plate.material: has no meaning beside materials");
  EXPECT_EQ(answer("element: hex, mass_scaling: {shift: 1}, thickness: 0.1, materials: {core: steel}"),
            "deck.yaml:6:42: bodies.plate.mass_scaling: has no meaning beside materials");
  EXPECT_EQ(answer("layers: [{material: steel, thickness: 0.001}]"),
            "deck.yaml:6:28: bodies.plate.layers: has no meaning with element tet10: only hex has it");
  EXPECT_EQ(answer("element: hex, thickness: 0.1, layers: [{material: steel, thickness: 0.001}]"),
            "deck.yaml:6:42: bodies.plate.thickness: has no meaning beside layers: each of them has its own");
  EXPECT_EQ(answer("element: hex, layers: [{material: steel}]"),
            "deck.yaml:6:51: bodies.plate.layers.0: the key 'thickness' is missing");
  const std::string slow = "  slow: {from: steel, damping: {mass: 5}}\n";
  EXPECT_EQ(
      answer("materials: {core: steel, head: slow}",
             replaced(slow, "from: steel", "young: 1e9, poisson: 0, density: 1")),
      "deck.yaml:7:53: bodies.plate.materials: the damping `mass` slows every motion of the whole body, so all its "
      "materials must have the same one, or mass_of: vibration");
}

TEST_F(Regions, APluckRefusesAMaterialThatCreeps) {
  const std::string creeps =
      "  creeping: {young: 1e9, poisson: 0, density: 1000, damping: {mass: 5, mass_of: vibration}}\n";
  EXPECT_THAT(
      mistakes(replaced(deck("materials: {core: steel, head: creeping}", creeps), "tap: {", "tap: {type: pluck, ")),
      testing::HasSubstr("materials.creeping.damping has mass_of: vibration"));
}

}  // namespace
}  // namespace idiophone::scene
