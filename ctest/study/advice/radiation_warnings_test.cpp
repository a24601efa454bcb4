#include "idiophone/study/advice/radiation_warnings.hpp"

#include <gmock/gmock.h>

#include "ranks.hpp"

namespace idiophone::advice {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

mesh::Statistics cuboid(const Vector3& extents) {
  mesh::Statistics mesh;
  mesh.extents = extents;
  mesh.volume = extents.prod();
  mesh.surface_area = 2.0 * (extents[0] * extents[1] + extents[1] * extents[2] + extents[2] * extents[0]);
  return mesh;
}

scene::Radiation with(scene::RadiationModel model) {
  scene::Radiation radiation;
  radiation.model = model;
  return radiation;
}

const mesh::Statistics cube = cuboid({0.1, 0.1, 0.1});
const mesh::Statistics bar = cuboid({0.3, 0.03, 0.01});
const mesh::Statistics plate = cuboid({0.3, 0.3, 0.006});

ON_RANKS(1);

TEST(RadiationWarning, DistrustsKirchhoffForThinBodies) {
  const auto kirchhoff = with(scene::RadiationModel::kirchhoff);
  EXPECT_FALSE(radiation_warning("cube", cube, kirchhoff));
  EXPECT_THAT(radiation_warning("bar", bar, kirchhoff).value_or(""), HasSubstr("body bar is thin"));
  EXPECT_THAT(radiation_warning("plate", plate, kirchhoff).value_or(""),
              AllOf(HasSubstr("from 134 to 4473 Hz; radiation model waves"), HasSubstr("idiophone radiate")));
}

TEST(RadiationWarning, DistrustsRayleighForBodiesThatAreNotFlat) {
  const auto rayleigh = with(scene::RadiationModel::rayleigh);
  EXPECT_THAT(radiation_warning("cube", cube, rayleigh).value_or(""), HasSubstr("body cube is not flat"));
  EXPECT_TRUE(radiation_warning("bar", bar, rayleigh));
  EXPECT_FALSE(radiation_warning("plate", plate, rayleigh));
}

TEST(RadiationWarning, SaysNothingOfOtherModels) {
  EXPECT_FALSE(radiation_warning("plate", plate, with(scene::RadiationModel::huygens)));
  EXPECT_FALSE(radiation_warning("plate", plate, with(scene::RadiationModel::waves)));
}

}  // namespace
}  // namespace idiophone::advice
