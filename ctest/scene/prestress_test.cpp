// The prestress of a body in a deck, and mistakes.

#include <cmath>

#include "deck_fixture.hpp"

namespace idiophone::scene {
namespace {

class PrestressKeys : public DeckTest {
 protected:
  /// The small deck with these keys of the body besides.
  [[nodiscard]] std::string deck(const std::string& keys) const {
    return replaced(plate, "material: steel", "material: steel, " + keys);
  }

  /// The small deck with these keys in place of those that hold the body.
  [[nodiscard]] std::string held(const std::string& keys) const { return replaced(plate, "fixed: [rim]", keys); }
};

TEST_F(PrestressKeys, StandInAnyOrder) {
  const Body body = read(deck("prestress: {xy: 4, zz: 3, xx: 1, yz: 5, yy: 2, xz: 6}")).bodies.at(0);
  Eigen::Matrix3d expected;
  expected << 1, 4, 6, 4, 2, 5, 6, 5, 3;
  EXPECT_EQ(body.initial_stress(), expected);
  EXPECT_EQ(read(plate).bodies.at(0).initial_stress(), Eigen::Matrix3d(Eigen::Matrix3d::Zero()));
}

TEST_F(PrestressKeys, TheStressTurnsWithTheBody) {
  const Body body = read(deck("prestress: {xx: 1e6}, rotation: {axis: [0, 0, 1], degrees: 30}")).bodies.at(0);
  const Vector3 along(std::cos(M_PI / 6), std::sin(M_PI / 6), 0);
  EXPECT_LT((body.initial_stress() - 1e6 * along * along.transpose()).norm(), 1e-9);
}

TEST_F(PrestressKeys, MistakesAreAnswered) {
  const auto answer = [&](const std::string& keys) { return mistakes(deck(keys)); };
  EXPECT_THAT(answer("prestress: {}"), testing::HasSubstr("bodies.plate.prestress: needs a stress other than 0 Pa"));
  EXPECT_THAT(answer("prestress: {zx: 1}"), testing::HasSubstr("bodies.plate.prestress.zx: unknown key"));
  EXPECT_THAT(answer("prestress: {xx: 1e13}"), testing::HasSubstr("bodies.plate.prestress.xx: "));
  EXPECT_THAT(answer("prestress: {xx: 1}, element: hex, mass_scaling: {shift: 1}"),
              testing::HasSubstr("bodies.plate.prestress: has no meaning with mass_scaling"));
  EXPECT_THAT(answer("prestress: {xx: 1}, fracture: [{surface: cracks, strength: 1}]"),
              testing::HasSubstr("bodies.plate.prestress: has no meaning with fracture"));
  EXPECT_THAT(answer("prestress: {temperature: 1}"),
              testing::HasSubstr("changes the temperature, and the material 'steel' has no `expansion`, 1/K"));
  const auto answer_held = [&](const std::string& keys) {
    return mistakes(held(keys + ", prestress: {stretch: {group: top, displacement: [1, 0, 0]}}"));
  };
  EXPECT_EQ(answer_held("fixed: [top]"), "no mistakes");
  EXPECT_THAT(answer_held("fixed: [bottom]"), testing::HasSubstr("stretches the group 'top', which needs to be in"));
  EXPECT_THAT(answer_held("fixed: [{group: top, axes: yz}]"),
              testing::HasSubstr("held along the axes of the displacement"));
  EXPECT_THAT(answer_held("fixed: [top], model: {type: modal, count: 1, large_amplitudes: true}"),
              testing::HasSubstr("which large_amplitudes can't have yet"));
}

TEST_F(PrestressKeys, TemperatureAndStretchAreRead) {
  const std::string keys =
      "fixed: [{group: top, axes: xy}], prestress: {temperature: -20, stretch: {group: top, displacement: [0.001, 0, "
      "0]}}";
  const Scene scene = read(replaced(held(keys), "density: 7850", "density: 7850, expansion: 1.2e-5"));
  const Prestress& prestress = *scene.bodies.at(0).prestress;
  EXPECT_EQ(prestress.temperature, -20);
  EXPECT_EQ(prestress.stretch->group, "top");
  EXPECT_EQ(prestress.stretch->displacement, Vector3(0.001, 0, 0));
  EXPECT_EQ(scene.materials.at(0).expansion, 1.2e-5);
}

}  // namespace
}  // namespace idiophone::scene
