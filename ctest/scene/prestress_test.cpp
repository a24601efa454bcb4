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
}

}  // namespace
}  // namespace idiophone::scene
