// Crystals in a deck: their constants, their axes, and mistakes.

#include <Eigen/Geometry>
#include <numbers>

#include "deck_fixture.hpp"
#include "idiophone/scene/euler_angles.hpp"

namespace idiophone::scene {
namespace {

class Crystals : public DeckTest {
 protected:
  /// The small deck with a body of a material with these keys, and more keys of the body.
  [[nodiscard]] std::string deck(const std::string& keys, const std::string& of_body = "") const {
    return replaced(replaced(plate, "materials:\n  steel: {young: 2.0e11, poisson: 0.3, density: 7850}\n",
                             "materials:\n  a: {" + keys + "}\n"),
                    "material: steel", "material: a" + of_body);
  }
  [[nodiscard]] Material material(const std::string& keys) const {
    const Scene scene = read(deck(keys));
    return scene.materials.at(scene.bodies.at(0).material);
  }

  /// McSkimin, Andreatch and Thurston, Journal of Applied Physics 36, 1965.
  static constexpr const char* quartz =
      "density: 2648, stiffness: {symmetry: trigonal, c11: 86.8e9, c12: 7.04e9, c13: 11.91e9, c14: -18.04e9, "
      "c33: 105.75e9, c44: 58.2e9}";
};

TEST_F(Crystals, HaveTheConstantsOfTheirSymmetry) {
  const Material found = material(quartz);
  EXPECT_FALSE(found.is_isotropic());
  EXPECT_EQ(found.crystal->symmetry, Symmetry::trigonal);
  StiffnessMatrix expected;
  expected << 86.8, 7.04, 11.91, -18.04, 0, 0,  //
      7.04, 86.8, 11.91, 18.04, 0, 0,           //
      11.91, 11.91, 105.75, 0, 0, 0,            //
      -18.04, 18.04, 0, 58.2, 0, 0,             //
      0, 0, 0, 0, 58.2, -18.04,                 //
      0, 0, 0, 0, -18.04, 39.88;
  EXPECT_LT((stiffness_matrix(*found.crystal) - 1e9 * expected).norm(), 1.0);
  EXPECT_NEAR(found.young, 102.7e9, 0.1e9) << "along z";
  EXPECT_EQ(material("density: 1, stiffness: {symmetry: tetragonal, c11: 9, c12: 1, c13: 1, c33: 9, c44: 4, c66: 4, "
                     "c16: -2}")
                .crystal->constants.back(),
            -2);
}

TEST_F(Crystals, ShowWhatResistsEachStrain) {
  const Material steel = material("young: 2e11, poisson: 0.3, density: 7850");
  const double mu = steel.young / 2.6;
  const Orthotropy disguised{Vector3::Constant(2e11), Vector3::Constant(0.3), Vector3::Constant(mu)};
  const Eigen::Vector<double, 6> moduli = kelvin_moduli(stiffness_matrix(disguised));
  EXPECT_LT((moduli.head<5>().array() - 2 * mu).abs().maxCoeff(), 1e-12 * mu);
  EXPECT_NEAR(moduli[5] / (2e11 / (1 - 2 * 0.3)), 1.0, 1e-12);
  const Orthotropy along = *constants_along_axes(material(quartz));
  EXPECT_NEAR(along.young[2] / (105.75e9 - 2 * 11.91e9 * 11.91e9 / (86.8e9 + 7.04e9)), 1.0, 1e-12);
  EXPECT_EQ(constants_along_axes(steel).has_value(), false);
}

TEST_F(Crystals, LieAsEulersAnglesSay) {
  const auto axes = [&](const std::string& angles) {
    return read(deck(quartz, ", grain: {euler: " + angles + "}")).bodies.at(0).material_axes();
  };
  const Eigen::Matrix3d turned = axes("[90, 90, 0]");  // x to y; then about the new x: z to the old x
  EXPECT_LT((turned.col(0) - Vector3(0, 1, 0)).norm(), 1e-15);
  EXPECT_LT((turned.col(1) - Vector3(0, 0, 1)).norm(), 1e-15);
  EXPECT_LT((turned.col(2) - Vector3(1, 0, 0)).norm(), 1e-15);
  EXPECT_LT((axes("[20, 0, 30]") - axes("[50, 0, 0]")).norm(), 1e-15);
  EXPECT_LT((axes("[90, 90, 90]").col(0) - Vector3(0, 0, 1)).norm(), 1e-15) << "the last turn is about the new z";
}

TEST(EulerAngles, AreThoseOfTheAxes) {
  for (const Vector3& angles :
       {Vector3(-170, 35, 120), Vector3(20, 150, -60), Vector3(70, 0, 0), Vector3(70, 180, 0)}) {
    EXPECT_LT((euler_angles(axes_of_euler_angles(angles)) - angles).norm(), 1e-9) << angles.transpose();
  }
  EXPECT_LT((euler_angles(axes_of_euler_angles({20, 0, 30})) - Vector3(50, 0, 0)).norm(), 1e-9);
}

TEST_F(Crystals, MistakesAreAnswered) {
  const auto answer = [&](const std::string& keys) { return mistakes(deck(keys)); };
  const std::string cubic = "density: 1, stiffness: {symmetry: cubic, c11: 3e9, c12: ";
  EXPECT_EQ(answer(cubic + "1e9}"), "deck.yaml:4:30: materials.a.stiffness: the key 'c44' is missing");
  EXPECT_EQ(answer(cubic + "1e9, c44: 1e9, c66: 1e9}"),
            "deck.yaml:4:78: materials.a.stiffness.c66: unknown key, known here: symmetry, c11, c12, c44");
  EXPECT_EQ(
      answer(cubic + "4e9, c44: 1e9}"),
      "deck.yaml:4:30: materials.a.stiffness: this stiffness is not positive definite: its smallest eigenvalue is "
      "-1e+09 Pa, and must be at least 1.1e+06 Pa, 0.0001 of the largest; such a crystal would gain energy by "
      "being strained");
  EXPECT_THAT(answer(cubic + "1e9, c44: -1e9}"), testing::HasSubstr("c44: must be at least 1 and at most 1"));
  EXPECT_THAT(answer("density: 1, stiffness: {symmetry: cubical}"), testing::HasSubstr("did you mean 'cubic'?"));
  EXPECT_THAT(answer(cubic + "1e9, c44: 1e9}, young: 1e9"),
              testing::HasSubstr("materials.a.young: has no meaning beside the key stiffness"));
  EXPECT_EQ(
      mistakes(deck(quartz, ", grain: {euler: [0, 0, 0], x: [1, 0, 0]}")).find("x: has no meaning beside euler") ==
          std::string::npos,
      false);
}

}  // namespace
}  // namespace idiophone::scene
