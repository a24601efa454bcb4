#include "idiophone/solids/accuracy/pitch_error.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace idiophone::accuracy {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

const scene::Material steel{"steel", 2e11, 0.3, 7850, {}, {}};
constexpr double plate_thickness = 0.003;  // m

/// A plate made of cells of a size, m.
mesh::Statistics plate(double size) {
  return {.largest_edge = std::sqrt(2.0) * size,
          .volume = 0.09 * plate_thickness,
          .volumes = {},
          .surface_area = 2 * 0.09,
          .extents = {0.3, 0.3, plate_thickness}};
}

const Extents narrow{{0.01, 0.01, plate_thickness},
                     plate_thickness};  // its torsion is far above the waves of these tests

/// Cells as wide as they are long, m, no longer than a layer is thick.
Cells cells(double size) {
  return {.type = element::tet10, .size = size, .across = size, .layer = std::min(size, plate_thickness)};
}

scene::Body plate_of(element::Type element) {
  scene::Body body;
  body.name = "plate";
  body.element = element;
  return body;
}

TEST(BendingWavelength, OfSlowWavesIsThatOfThinPlates) {
  constexpr double frequency = 10.0;
  const double stiffness = steel.young * std::pow(plate_thickness, 3) / 12 / (1 - steel.poisson * steel.poisson);
  const double omega = 2 * std::numbers::pi * frequency;
  const double thin =
      2 * std::numbers::pi * std::pow(stiffness / (steel.density * plate_thickness * omega * omega), 0.25);
  EXPECT_NEAR(bending_wavelength(steel, plate_thickness, frequency), thin, 1e-4 * thin);
}

TEST(BendingWavelength, OfFastWavesIsThatOfRayleighWaves) {
  constexpr double frequency = 1e9;
  const double rayleigh = 0.93 * std::sqrt(steel.young / (2 * (1 + steel.poisson)) / steel.density);
  EXPECT_NEAR(bending_wavelength(steel, plate_thickness, frequency), rayleigh / frequency, 1e-3 * rayleigh / frequency);
}

TEST(PlateSpeed, IsThatOfTheSoftestAxis) {
  EXPECT_NEAR(plate_speed(steel), std::sqrt(2e11 / 0.91 / 7850), 1e-9);
  scene::Material wood{"wood", 1.6e10, 0.0, 400, {}, {}};
  wood.orthotropy = {.young = {1.6e10, 9e8, 4e8}, .shear = {1e9, 5e8, 4e7}};
  EXPECT_NEAR(plate_speed(wood), 1000.0, 1e-9);
}

TEST(PitchError, GrowsWithTheSquareOfTheElementsInAWaveAndWithTheirSlenderness) {
  constexpr double frequency = 500.0;
  const auto factor = [&](double size) {
    return pitch_error(cells(size), narrow, steel, frequency) /
           std::pow(size / bending_wavelength(steel, plate_thickness, frequency), 2);
  };
  EXPECT_NEAR(factor(plate_thickness / 100), 2000, 1);
  EXPECT_NEAR(factor(4 * plate_thickness), 4250, 1e-6);
  EXPECT_NEAR(factor(1000 * plate_thickness), 6500, 1);
}

TEST(HighestFrequency, IsWhereTheErrorReachesTheCents) {
  for (const double cents : {5.0, 50.0}) {
    const double highest = highest_frequency(cells(0.006), narrow, steel, cents);
    EXPECT_NEAR(pitch_error(cells(0.006), narrow, steel, highest), cents, 1e-3 * cents);
  }
}

TEST(WithoutRules, AreBodiesThatAreNotOneFlatPieceOfOneMaterial) {
  const mesh::Statistics flat = plate(0.01);
  mesh::Statistics bowed = flat;
  bowed.extents = {0.3, 0.3, 2.1 * plate_thickness};
  scene::Body body = plate_of(element::tet10);
  EXPECT_EQ(without_rules(body, flat), std::nullopt);
  EXPECT_EQ(without_rules(body, bowed), "curved or joined thin walls");
  bowed.extents[2] = 1.9 * plate_thickness;
  EXPECT_EQ(without_rules(body, bowed), std::nullopt);
  body.prestress.emplace();
  EXPECT_EQ(without_rules(body, flat), "bodies under tension");
  body.regions.resize(1);
  EXPECT_EQ(without_rules(body, flat), "bodies of several materials");
}

TEST(MeshWarning, NamesTetrahedraThatLock) {
  const auto warning = mesh_warning(plate(plate_thickness / 7), plate_of(element::tet4), steel, 1000);
  ASSERT_TRUE(warning);
  EXPECT_THAT(*warning, AllOf(HasSubstr("body plate: tet4 elements of 0.000429 m lock in a part 0.003 m thick"),
                              HasSubstr("use element: tet10")));
  EXPECT_FALSE(mesh_warning(plate(plate_thickness / 9), plate_of(element::tet4), steel, 1000));
}

TEST(MeshWarning, NamesElementsThatAreTooLongForTheWaves) {
  constexpr double highest = 10e3;
  const double longest = bending_wavelength(steel, plate_thickness, highest) / 4;  // four elements in a wave
  EXPECT_FALSE(mesh_warning(plate(0.99 * longest), plate_of(element::tet10), steel, highest));
  EXPECT_TRUE(mesh_warning(plate(1.01 * longest), plate_of(element::tet10), steel, highest));
  const auto warning = mesh_warning(plate(2 * longest), plate_of(element::tet10), steel, highest);
  ASSERT_TRUE(warning);
  EXPECT_THAT(*warning, AllOf(HasSubstr("too coarse above"), HasSubstr("at 10000 Hz bending waves are 2.0 elements"),
                              HasSubstr("Use elements of 0.0")));
}

TEST(MeshWarning, KnowsNothingOfHexahedra) {
  EXPECT_FALSE(mesh_warning(plate(1.0), plate_of(element::hex(4, 4)), steel, 20e3));
}

}  // namespace
}  // namespace idiophone::accuracy
