// Strings, bars and plates against the formulas of textbooks; membranes and plates by elements have tests of their own
// in the module eigenmodes.

#include "idiophone/instruments/sound_maps/ideal_map.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "beam_modes.hpp"
#include "idiophone/instruments/sound_maps/modal_radiation.hpp"
#include "ranks.hpp"

namespace idiophone::sound_maps {
namespace {

using Ends = sound_maps::IdealBody::Ends;
using Type = sound_maps::IdealBody::Type;
using std::numbers::pi;

sound_maps::IdealBody unit_body(Type type) {
  sound_maps::IdealBody body;
  body.name = "body";
  body.type = type;
  body.length = 1;
  body.width = type == Type::plate ? 1 : 0.01;
  body.density = 1;
  return body;
}

/// A square plate of unit side by elements.
sound_maps::IdealBody meshed_plate(eigenmodes::PlateEdge edges) {
  sound_maps::IdealBody plate = unit_body(Type::plate);
  plate.length = plate.width = 0;
  plate.region.outline.polygon = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  plate.edges = {{edges, edges, edges, edges}};
  plate.size = 0.05;
  plate.stiffness = 1e4;
  return plate;
}

/// With its pressure at a listener in front of it.
sound_maps::SoundMap heard_map(const sound_maps::IdealBody& body, int count) {
  scene::Scene scene;
  scene::Listener ear;
  ear.name = "ear";
  ear.receivers.push_back({.channel = "ear", .position = {0.3, 0.4, 0.8}});
  scene.listeners.push_back(ear);
  sound_maps::SoundMap map = ideal_map(scene, body, count, {});
  map.sphere = sphere_of_directions(8);
  add_radiation(map, scene, rigid_wall(), MPI_COMM_SELF);
  return map;
}

/// Sum of phi_a phi_b mass over the vertices of a line or a plate.
double modal_product(const sound_maps::SoundMap& map, std::size_t a, std::size_t b) {
  double sum = 0.0;
  for (const auto& triangle : map.triangles) {  // two triangles of a cell share its diagonal
    double mean = 0.0;
    for (const Index vertex : triangle) {
      mean += map.shape_of(a)[3 * vertex + 2] * map.shape_of(b)[3 * vertex + 2] / 3;
    }
    sum += mean / static_cast<double>(map.triangles.size());
  }
  return sum * map.mass;
}

ON_RANKS(1);

TEST(BeamModes, HaveTheRootsOfTextbooks) {
  EXPECT_NEAR(beam_root(Ends::clamped_free, 1), 1.875104, 1e-6);
  EXPECT_NEAR(beam_root(Ends::clamped_free, 2), 4.694091, 1e-6);
  EXPECT_NEAR(beam_root(Ends::free, 1), 4.730041, 1e-6);
  EXPECT_NEAR(beam_root(Ends::clamped, 2), 7.853205, 1e-6);
  EXPECT_NEAR(beam_root(Ends::free, 300), 300.5 * pi, 1e-9);
}

TEST(BeamModes, MeetTheirEnds) {
  for (const int n : {1, 2, 7, 300}) {
    EXPECT_NEAR(beam_shape(Ends::clamped, beam_root(Ends::clamped, n), 0), 0, 1e-9);
    EXPECT_NEAR(beam_shape(Ends::clamped, beam_root(Ends::clamped, n), 1), 0, 1e-9);
    EXPECT_NEAR(std::abs(beam_shape(Ends::free, beam_root(Ends::free, n), 0)), 2, 1e-9);
    EXPECT_NEAR(std::abs(beam_shape(Ends::free, beam_root(Ends::free, n), 1)), 2, 1e-9);
    EXPECT_NEAR(beam_shape(Ends::clamped_free, beam_root(Ends::clamped_free, n), 0), 0, 1e-9);
    EXPECT_NEAR(std::abs(beam_shape(Ends::clamped_free, beam_root(Ends::clamped_free, n), 1)), 2, 1e-9);
  }
}

TEST(IdealMap, OfAStringIsHarmonicAndDecaysByItsFriction) {
  sound_maps::IdealBody string = unit_body(Type::string);
  string.tension = 4e4;
  string.friction = 0.01;
  const sound_maps::SoundMap map = ideal_map({}, string, 30, {});
  ASSERT_EQ(map.modes(), 30);
  EXPECT_NEAR(map.frequency[0], 100, 1e-9);
  EXPECT_NEAR(map.frequency[29], 3000, 1e-9);
  EXPECT_NEAR(map.material_decay[4], pi * 500 * 0.01, 1e-9);
  EXPECT_NEAR(map.mass, 1, 1e-12);
  EXPECT_NEAR(modal_product(map, 2, 2), 1, 1e-4);
  EXPECT_NEAR(modal_product(map, 2, 5), 0, 1e-4);
  EXPECT_EQ(ideal_map({}, string, 0, 450.0).modes(), 4);
}

TEST(IdealMap, OfABarHasUnitModalMass) {
  for (const Ends ends : {Ends::supported, Ends::free, Ends::clamped, Ends::clamped_free}) {
    sound_maps::IdealBody bar = unit_body(Type::bar);
    bar.stiffness = 100;
    bar.ends = ends;
    const sound_maps::SoundMap map = ideal_map({}, bar, 12, {});
    EXPECT_NEAR(map.frequency[3], 10 * std::pow(beam_root(ends, 4), 2) / (2 * pi), 1e-6);
    EXPECT_NEAR(modal_product(map, 1, 1), 1, 0.02);
    EXPECT_NEAR(modal_product(map, 0, 2), 0, 0.02);
  }
}

TEST(IdealMap, OfAPlateHasTheSquaresOfWaveNumbers) {
  sound_maps::IdealBody plate = unit_body(Type::plate);
  plate.width = 0.5;
  plate.stiffness = 4;
  const sound_maps::SoundMap map = ideal_map({}, plate, 20, {});
  const double unit = pi * pi * 2 / (2 * pi);
  const std::vector<double> exact = {5, 8, 13, 17, 20, 20};  // m^2 + 4 n^2
  for (std::size_t i = 0; i < exact.size(); ++i) {
    EXPECT_NEAR(map.frequency[i] / unit, exact[i], 1e-9) << i;
  }
  EXPECT_NEAR(modal_product(map, 3, 3), 1, 0.02);
  EXPECT_NEAR(map.centre[1], 0.25, 1e-9);
}

/// The same body by elements and by formulas, whose surface has four cells for a half wave of the highest mode.
TEST(IdealMap, OfASupportedPolygonIsThatOfTheFormulas) {
  const sound_maps::IdealBody plate = meshed_plate(eigenmodes::PlateEdge::supported);
  sound_maps::IdealBody formula = plate;
  formula.length = formula.width = 1;
  const sound_maps::SoundMap meshed = heard_map(plate, 5), exact = heard_map(formula, 60);
  EXPECT_NE(meshed.vertices.size(), exact.vertices.size());
  for (const std::size_t mode : {0, 3}) {  // modes 1 and 2 have one frequency
    EXPECT_NEAR(meshed.frequency[mode] / exact.frequency[mode], 1, 1e-4);
    const auto ratio = meshed.listeners[0].pressure[mode] / exact.listeners[0].pressure[mode];
    EXPECT_NEAR(std::abs(ratio), 1, 0.03) << mode;
    EXPECT_NEAR(meshed.radiation_decay[mode] / exact.radiation_decay[mode], 1, 0.05) << mode;
  }
  EXPECT_NEAR(meshed.mass, 1, 1e-12);
  formula.edges.front().back() = eigenmodes::PlateEdge::clamped;
  EXPECT_GT(ideal_map({}, formula, 1, {}).frequency[0], 1.1 * exact.frequency[0]) << "a rectangle with a clamped side";
}

TEST(IdealMap, OfAFreePlateWithAHoleLosesItsMass) {
  sound_maps::IdealBody plate = meshed_plate(eigenmodes::PlateEdge::free);
  plate.region.holes.resize(1);
  plate.region.holes[0].radius = 0.2;
  plate.region.holes[0].centre = {0.6, 0.5};
  plate.edges.push_back({eigenmodes::PlateEdge::free});
  const sound_maps::SoundMap map = ideal_map({}, plate, 2, {});
  EXPECT_NEAR(map.mass, 1 - pi * 0.04, 1e-3);
  EXPECT_NEAR(map.centre[0], (0.5 - pi * 0.04 * 0.6) / (1 - pi * 0.04), 1e-4);
  EXPECT_LT(map.frequency[0] * 2 * pi / 100, 13.47);
}

TEST(IdealMap, OfAMembraneHasTheMassOfItsFormula) {
  sound_maps::IdealBody membrane = meshed_plate(eigenmodes::PlateEdge::supported);
  membrane.type = Type::membrane;
  membrane.tension = 100;
  membrane.density_formula = "1 + 2*x";
  const sound_maps::SoundMap map = ideal_map({}, membrane, 2, {});
  EXPECT_NEAR(map.mass, 2, 1e-6);
  EXPECT_NEAR(map.centre[0], 7.0 / 12, 1e-3);
  membrane.density_formula = "0.5 - x";
  EXPECT_THROW((void)ideal_map({}, membrane, 2, {}), deck::DeckError);
  membrane.density_formula = "exp(700*x)";
  EXPECT_THROW((void)ideal_map({}, membrane, 2, {}), deck::DeckError);
  membrane.density_formula = "1/(x - x)";
  EXPECT_THROW((void)ideal_map({}, membrane, 2, {}), deck::DeckError);
}

TEST(IdealMap, OfAMembraneTakesItsDensityFromPoints) {
  sound_maps::IdealBody membrane = meshed_plate(eigenmodes::PlateEdge::supported);
  membrane.type = Type::membrane;
  membrane.tension = 100;
  membrane.density_formula = "1 + 2*x";
  const sound_maps::SoundMap formula = ideal_map({}, membrane, 4, {});
  membrane.density_formula.clear();
  membrane.density_points = {{0, 0, 1}, {1, 0, 3}, {0, 1, 1}, {1, 1, 3}, {0.4, 0.7, 1.8}};
  const sound_maps::SoundMap points = ideal_map({}, membrane, 4, {});
  EXPECT_NEAR(points.mass, formula.mass, 1e-6);
  for (std::size_t mode = 0; mode < 4; ++mode) {
    EXPECT_NEAR(points.frequency[mode] / formula.frequency[mode], 1, 1e-6) << mode;
  }
  membrane.density_points = {{0, 0, 1}, {0.1, 0, 0.5}};  // its line falls below zero
  EXPECT_THROW((void)ideal_map({}, membrane, 2, {}), deck::DeckError);
}

}  // namespace
}  // namespace idiophone::sound_maps
