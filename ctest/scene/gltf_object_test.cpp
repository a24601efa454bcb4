// What decks take from a glTF file besides its shape: the material of an object, and its mass.

#include "gltf_object.hpp"
#include "deck_fixture.hpp"

namespace idiophone::scene {

using ::testing::HasSubstr;

class GltfObject : public DeckTest {
 protected:
  /// The small deck with a body from this glTF file and without a material; more keys of the body are in `keys`.
  [[nodiscard]] std::string deck(const std::string& gltf, const std::string& keys = "") const {
    write("things.gltf", gltf);
    return replaced(plate, "mesh: plate.geo, material: steel, fixed: [rim]", "mesh: things.gltf" + keys);
  }

  /// Two objects of different materials, which are seen; the bowl has a mass.
  const std::string things =
      R"({"nodes": [{"name": "bowl", "mesh": 0, "extensions": {"KHR_physics_rigid_bodies": {"motion": {"mass": 2.5}}}},
          {"name": "stand", "children": [2]}, {"name": "foot", "mesh": 1}],
         "meshes": [{"primitives": [{"material": 1}]}, {"name": "disc", "primitives": [{"material": 0}]}],
         "materials": [{"name": "aluminium"}, {"name": "steel"}]})";

  /// One object with an acoustic material of this name and density.
  [[nodiscard]] static std::string acoustic(const std::string& name, double density) {
    return fmt::format(R"({{"nodes": [{{"extensions": {{"KHR_audio_rigid_bodies": {{"modalModel": 0}}}}}}],
      "extensions": {{"KHR_audio_rigid_bodies": {{"modalModels": [{{"material": 0, "massProperties": {{"mass": 3}}}}],
        "acousticMaterials": [{{"name": "{}", "density": {}, "youngsModulus": 7e10}}]}}}}}})",
                       name, density);
  }
};

TEST_F(GltfObject, HasItsMaterialAndItsMass) {
  const Scene bowl = read(deck(things, ", object: bowl"));
  EXPECT_EQ(bowl.materials[bowl.bodies[0].material].name, "steel");
  EXPECT_EQ(bowl.bodies[0].file_mass, 2.5);
  for (const std::string object : {"stand", "foot", "disc"}) {  // a node above it, the node, and its mesh
    const Scene foot = read(deck(things, ", object: " + object));
    EXPECT_EQ(foot.materials[foot.bodies[0].material].name, "aluminium") << object;
    EXPECT_FALSE(foot.bodies[0].file_mass);
  }
}

TEST_F(GltfObject, HasTheMaterialThatTheDeckNames) {
  const Scene scene = read(deck(things, ", object: bowl, material: glass"));
  EXPECT_EQ(scene.materials[scene.bodies[0].material].name, "glass");
}

TEST_F(GltfObject, HasAnAcousticMaterialBeforeOneThatIsSeen) {
  const Scene scene = read(deck(acoustic("steel", 7850)));
  EXPECT_EQ(scene.materials[scene.bodies[0].material].name, "steel");
  EXPECT_EQ(scene.bodies[0].file_mass, 3.0);
}

TEST_F(GltfObject, WithoutAClearMaterialIsRefused) {
  const std::string place = "deck.yaml:6:17: bodies.plate.mesh: DIR/things.gltf ";
  EXPECT_EQ(mistakes(deck(things)), place + "gives it no material, or several: name one by the key material");
  EXPECT_EQ(mistakes(deck(things, ", object: cup")), place + "has no object 'cup'. It has: bowl, disc, foot, stand");
  EXPECT_EQ(mistakes(deck(acoustic("china", 2400))),
            place +
                "has the material 'china', which the deck doesn't know. Name another by the key material, or add to "
                "materials: china: {young: 7e+10, poisson: ..., density: 2400}");
  EXPECT_EQ(mistakes(deck(acoustic("steel", 7000))),
            place + "says that 'steel' has 7000 kg/m3, but here it has 7850. Name a material by the key material");
}

TEST_F(GltfObject, DamageIsNamed) {
  for (const std::string text :
       {"", "{", R"({"nodes": 3})", R"({"nodes": [{"mesh": 7}], "meshes": []})", R"({"nodes": [{"children": [9]}]})",
        R"({"nodes": [{"name": 3}]})", R"({"nodes": [{"mesh": -1}], "meshes": [{}]})", "glTF", "glTF\2\0\0\0\1"}) {
    EXPECT_THAT(mistakes(deck(text)), HasSubstr("bodies.plate.mesh: DIR/things.gltf ")) << text;
  }
  EXPECT_THAT(mistakes(deck(R"({"nodes": [{"children": [0]}]})")), HasSubstr("gives it no material"));  // a ring
}

TEST_F(GltfObject, IsRefusedWhereFilesHaveNone) {
  EXPECT_EQ(
      mistakes(replaced(plate, "plate.geo", "shapes/bar.msh, object: bar")),
      "deck.yaml:6:33: bodies.plate.object: has no meaning: a .msh file has no named objects, as .obj, .gltf, .glb, "
      ".fbx files have");
}

}  // namespace idiophone::scene
