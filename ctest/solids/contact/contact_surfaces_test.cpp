// Stiffness of contacts, and what it does to the stable step.

#include "idiophone/solids/contact/contact_surfaces.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "block_mesh.hpp"
#include "idiophone/scene/scene.hpp"
#include "ranks.hpp"

namespace idiophone::contact {
namespace {

/// Two blocks of two cubes, and one that touches nothing; the first two touch each other, and the first one a floor.
struct Blocks {
  Blocks() {
    for (int b = 0; b < 3; ++b) {
      meshes.push_back(support::block_mesh(element::tet4, {1, 1, 1.0 + b}, {1, 1, 2}));
    }
    scene.bodies.resize(3);
    scene.obstacles.resize(1);
    scene::Contact pair, floor;
    pair.body = 0;
    pair.other = 1;
    floor.body = 0;
    floor.obstacle = 0;
    scene.contacts = {pair, floor};
    surfaces = find_contact_surfaces(scene, meshes);
    inverse_mass.assign(36, 0.0);
    inverse_mass[3] = 5.0;   // of the first block
    inverse_mass[15] = 7.0;  // of the second
    inverse_mass[30] = 1e9;  // of the one that touches nothing
  }
  [[nodiscard]] double area(std::size_t body, Index node) const {
    const Skin& skin = surfaces.skins[body];
    return skin.areas.at(static_cast<std::size_t>(std::ranges::find(skin.nodes, node) - skin.nodes.begin()));
  }

  std::vector<mesh::Mesh> meshes;
  scene::Scene scene;
  ContactSurfaces surfaces;
  std::vector<double> inverse_mass;
};

ON_RANKS(1, 3);

TEST(ContactSurfaces, AreThoseOfBodiesThatTouchSomething) {
  const Blocks blocks;
  ASSERT_EQ(blocks.surfaces.skins.size(), 3U);
  EXPECT_EQ(blocks.surfaces.skins[0].nodes.size(), 12U);
  EXPECT_EQ(blocks.surfaces.skins[1].nodes.front(), 12);  // numbered over all bodies
  EXPECT_TRUE(blocks.surfaces.skins[2].nodes.empty());
  EXPECT_EQ(blocks.surfaces.shapes.size(), 1U);
}

TEST(ContactSurfaces, AreAsStiffAsTheShareOfTheLargestFrequencyAllows) {  // k = share w^2 / (A/m + A/m)
  Blocks blocks;
  choose_stiffness(blocks.scene, blocks.inverse_mass, 1000.0, 0.25, blocks.surfaces);
  ASSERT_EQ(blocks.surfaces.stiffness.size(), 2U);
  const double first = 5.0 * blocks.area(0, 3), second = 7.0 * blocks.area(1, 15);
  EXPECT_NEAR(blocks.surfaces.stiffness[0] * (first + second) / 0.25e6, 1.0, 1e-14);
  EXPECT_NEAR(blocks.surfaces.stiffness[1] * first / 0.25e6, 1.0, 1e-14);
}

TEST(ContactSurfaces, TakeTheStiffnessOfTheDeck) {
  Blocks blocks;
  blocks.scene.contacts[1].stiffness = 123.0;
  choose_stiffness(blocks.scene, blocks.inverse_mass, 1000.0, 0.25, blocks.surfaces);
  EXPECT_EQ(blocks.surfaces.stiffness[1], 123.0);
  EXPECT_NE(blocks.surfaces.stiffness[0], 123.0);
}

TEST(ContactSurfaces, OfBodiesThatAreHeldEverywhereHaveNoStiffness) {
  Blocks blocks;
  choose_stiffness(blocks.scene, std::vector<double>(36), 1000.0, 0.25, blocks.surfaces);
  EXPECT_THAT(blocks.surfaces.stiffness, testing::ElementsAre(0.0, 0.0));
}

TEST(ContactSurfaces, RaiseTheSquaredFrequencyOfBothPartners) {
  Blocks blocks;
  blocks.surfaces.stiffness = {10.0, 1000.0};
  const double first = 5.0 * blocks.area(0, 3), second = 7.0 * blocks.area(1, 15);
  const auto squares = squared_frequencies(blocks.scene, blocks.inverse_mass, blocks.surfaces);
  EXPECT_THAT(squares, testing::ElementsAre(testing::DoubleEq(1000.0 * first),  // the larger one of its two contacts
                                            testing::DoubleEq(10.0 * (first + second)), 0.0));
}

TEST(ContactSurfaces, WithBristlesStiffenAndDampBothPartners) {
  Blocks blocks;
  blocks.surfaces.stiffness = {10.0, 1000.0};
  blocks.scene.contacts[0].friction.memory = friction::Law{.stiffness = 3.0, .damping = 0.5, .viscosity = 0.25};
  blocks.scene.contacts[1].friction.memory = friction::Law{.stiffness = 100.0};
  const double first = 5.0, second = 7.0;  // largest inverse masses, 1/kg
  const auto bounds = bristle_bounds(blocks.scene, blocks.inverse_mass, blocks.surfaces);
  EXPECT_DOUBLE_EQ(bounds[1].square, 3.0 * (first + second));
  EXPECT_DOUBLE_EQ(bounds[1].damping, 0.75 * (first + second));
  EXPECT_DOUBLE_EQ(bounds[0].square, 3.0 * (first + second) + 100.0 * first);
  EXPECT_EQ(bounds[2].square, 0.0);
}

TEST(ContactSurfaces, WithBristlesBoundABodyThatTouchesItselfAsTwoBodies) {
  Blocks blocks;
  blocks.scene.contacts = {scene::Contact()};
  blocks.scene.contacts[0].other = blocks.scene.contacts[0].body = 0;
  blocks.scene.contacts[0].friction.memory = friction::Law{.stiffness = 3.0, .damping = 0.5, .viscosity = 0.25};
  const auto bounds = bristle_bounds(blocks.scene, blocks.inverse_mass, blocks.surfaces);
  EXPECT_DOUBLE_EQ(bounds[0].square, 3.0 * (5.0 + 5.0));
  EXPECT_DOUBLE_EQ(bounds[0].damping, 0.75 * (5.0 + 5.0));
}

TEST(ContactSurfaces, ChosenForAShareReachIt) {
  Blocks blocks;
  choose_stiffness(blocks.scene, blocks.inverse_mass, 1000.0, stiffness_share, blocks.surfaces);
  const auto squares = squared_frequencies(blocks.scene, blocks.inverse_mass, blocks.surfaces);
  EXPECT_NEAR(squares[0], stiffness_share * 1e6, 1e-6);
  EXPECT_NEAR(squares[1], stiffness_share * 1e6, 1e-6);
}

TEST(ContactSurfaces, AreStifferWhereAllBodiesAreHexahedra) {
  Blocks blocks;
  blocks.scene.bodies[0].element = element::hex(2, 2);
  choose_stiffness(blocks.scene, blocks.inverse_mass, 1000.0, stiffness_share_of_hexahedra, blocks.surfaces);
  const double first = 5.0 * blocks.area(0, 3), second = 7.0 * blocks.area(1, 15);
  EXPECT_NEAR(blocks.surfaces.stiffness[0] * (first + second), stiffness_share * 1e6, 1e-6);  // with tetrahedra
  EXPECT_NEAR(blocks.surfaces.stiffness[1] * first, stiffness_share_of_hexahedra * 1e6, 1e-6);
}

TEST(ContactSurfaces, AreTheSameOnAllRanks) {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  Blocks blocks;
  blocks.surfaces.stiffness = {10.0, 1000.0};
  const ContactSurfaces found = broadcast(rank == 0 ? blocks.surfaces : ContactSurfaces{}, MPI_COMM_WORLD);
  EXPECT_EQ(found.stiffness, blocks.surfaces.stiffness);
  ASSERT_EQ(found.skins.size(), 3U);
  EXPECT_EQ(found.skins[1].nodes, blocks.surfaces.skins[1].nodes);
  EXPECT_EQ(found.skins[1].cells, blocks.surfaces.skins[1].cells);
  EXPECT_EQ(found.skins[1].areas, blocks.surfaces.skins[1].areas);
  EXPECT_EQ(found.skins[1].exterior, blocks.surfaces.skins[1].exterior);
  EXPECT_EQ(found.skins[1].thinnest, blocks.surfaces.skins[1].thinnest);
}

}  // namespace
}  // namespace idiophone::contact
