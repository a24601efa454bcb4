// The stiffness of each symmetry stays as it is when the crystal is turned about its own axes of symmetry, and about no
// other.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

#include "idiophone/solids/solid/elasticity.hpp"

namespace idiophone::solid {
namespace {

using scene::Symmetry;

struct SymmetryCase {
  const char* name;
  Symmetry symmetry;
  int count;                             ///< of independent constants, with those that some classes lack
  std::vector<Eigen::AngleAxisd> turns;  ///< that make all rotations of the symmetry
};

Eigen::AngleAxisd turn(int order, const Vector3& axis) {
  return {2 * std::numbers::pi / order, axis.normalized()};
}

/// A material whose constants are all different.
scene::Material crystal(Symmetry symmetry) {
  scene::Material material;
  material.crystal = {symmetry, {}};
  for (const scene::CrystalConstant& constant : independent_constants(symmetry)) {
    const double number = (constant.name[1] - '0') + 0.13 * (constant.name[2] - '0');
    material.crystal->constants.push_back(constant.is_diagonal ? 100e9 + 7e9 * number : 5e9 * number);
  }
  return material;
}

/// How much a turn of the axes changes the stiffness, of 1.
double change(const scene::Material& material, const Eigen::AngleAxisd& turn) {
  const StiffnessMatrix own = stiffness_matrix(elasticity(material));
  return (stiffness_matrix(elasticity(material, turn.toRotationMatrix())) - own).norm() / own.norm();
}

class CrystalTest : public ::testing::TestWithParam<SymmetryCase> {};

TEST_P(CrystalTest, IsTheSameAfterATurnAboutItsAxes) {
  const auto& [name, symmetry, count, turns] = GetParam();
  EXPECT_EQ(independent_constants(symmetry).size(), static_cast<std::size_t>(count));
  const scene::Material material = crystal(symmetry);
  for (const Eigen::AngleAxisd& turn : turns) {
    EXPECT_LT(change(material, turn), 1e-14);
  }
  EXPECT_GT(change(material, turn(5, Vector3(1, 2, 3))), 1e-3);
  if (symmetry != Symmetry::hexagonal) {
    EXPECT_GT(change(material, turn(5, Vector3::UnitZ())), 1e-3);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Symmetries, CrystalTest,
    ::testing::Values(
        SymmetryCase{"cubic", Symmetry::cubic, 3, {turn(4, Vector3::UnitZ()), turn(3, Vector3::Ones())}},
        SymmetryCase{"hexagonal", Symmetry::hexagonal, 5, {turn(5, Vector3::UnitZ()), turn(2, Vector3::UnitX())}},
        SymmetryCase{"trigonal", Symmetry::trigonal, 7, {turn(3, Vector3::UnitZ())}},
        SymmetryCase{"tetragonal", Symmetry::tetragonal, 7, {turn(4, Vector3::UnitZ())}},
        SymmetryCase{"orthotropic", Symmetry::orthotropic, 9, {turn(2, Vector3::UnitZ()), turn(2, Vector3::UnitX())}},
        SymmetryCase{"monoclinic", Symmetry::monoclinic, 13, {turn(2, Vector3::UnitY())}},
        SymmetryCase{"triclinic", Symmetry::triclinic, 21, {}}),
    [](const auto& test) { return std::string(test.param.name); });

// Classes with a second axis: the optional constants vanish.
TEST(Crystal, OptionalConstantsBreakTheSecondAxis) {
  for (const Symmetry symmetry : {Symmetry::trigonal, Symmetry::tetragonal}) {
    scene::Material material = crystal(symmetry);
    const Eigen::AngleAxisd half = turn(2, Vector3::UnitX());
    EXPECT_GT(change(material, half), 1e-3);
    material.crystal->constants.back() = 0.0;
    EXPECT_LT(change(material, half), 1e-14);
  }
}

TEST(Crystal, WithTheConstantsOfAnotherKindIsThatKind) {
  scene::Material material{"steel", 2e11, 0.3, 7850, {}, {}};
  const StiffnessMatrix isotropic = stiffness_matrix(elasticity(material));
  material.crystal = {Symmetry::cubic, {isotropic(0, 0), isotropic(0, 1), isotropic(3, 3)}};
  EXPECT_LT(change(material, turn(5, Vector3(1, 2, 3))), 1e-14);
  EXPECT_LT((stiffness_matrix(elasticity(material)) - isotropic).norm(), 1e-14 * isotropic.norm());
}

}  // namespace
}  // namespace idiophone::solid
