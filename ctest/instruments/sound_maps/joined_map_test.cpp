// Maps of bodies that joints tie together, against those of the same body in one piece.

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <numeric>

#include "idiophone/instruments/sound_maps/air_mass.hpp"
#include "idiophone/instruments/sound_maps/blow.hpp"
#include "idiophone/instruments/sound_maps/modal_radiation.hpp"
#include "idiophone/instruments/sound_maps/solid_map.hpp"
#include "idiophone/instruments/sound_maps/solid_radiation.hpp"
#include "ranks.hpp"
#include "shared_folder.hpp"

namespace idiophone::sound_maps {
namespace {

/// A deck with bars of steel.
/// @param bodies  entries of `bodies` by bar()
std::string deck_of_bars(const std::string& bodies, const std::string& joints) {
  return fmt::format(R"(
name: bars
time: {{duration: 0.1}}
materials:
  steel: {{young: 2.0e11, poisson: 0.3, density: 7850, damping: {{mass: 2.0}}}}
bodies:
{}{}
listeners:
  above: {{type: mono, position: [0.1, 0.05, 0.3]}}
  beside: {{type: mono, position: [0.4, 0.1, -0.05]}}
)",
                     bodies, joints);
}

/// Of hexahedra, 30 mm wide.
/// @param size    of the elements, m
/// @param order   of the elements in the plane
/// @param layers  of elements across the thickness
std::string bar(const std::string& name, double length, double thickness, double size, const Vector3& position,
                int order = 4, int layers = 1) {
  return fmt::format(
      "  {}: {{mesh: {}/meshes/bar.geo, parameters: {{length: {}, width: 0.03, thickness: {}, size: {}, layers: {}}}, "
      "element: hex,"
      " order: {{plane: {}, thickness: 2}}, material: steel, position: [{}, {}, {}]}}\n",
      name, IDIOPHONE_SOURCE_DIR, length, thickness, size, layers, order, position[0], position[1], position[2]);
}

scene::Scene scene_of(const std::string& deck) {
  const support::Folder folder;
  std::ofstream(folder / "bars.yaml") << deck;
  return scene::read_deck(folder / "bars.yaml", {});
}

enum class Air { boundary_elements, sphere_patches };

SoundMap heard_map(const scene::Scene& scene, Air air, int modes) {
  SoundMap map = solid_map(scene, 0, {.count = modes}, eigenmodes::Estimates::none);
  map.sphere = sphere_of_directions(4);
  add_radiation(
      map, scene,
      air == Air::boundary_elements ? boundary_elements(map, scene.radiation) : sphere_patches(map, scene.radiation),
      MPI_COMM_SELF);
  return map;
}

/// Sound of a blow of 0.1 ms at a corner of the top.
std::vector<double> blow_sound(const SoundMap& map, std::size_t listener) {
  const Blow blow{.at = {0.003, -0.012, 0.005},
                  .direction = -Vector3::UnitZ(),
                  .force = [](double time) { return 20 * std::sin(std::numbers::pi * time / 1e-4); },
                  .duration = 1e-4};
  return sound_of(blow, map, listener, 44100, 4410);
}

double sound_level(const std::vector<double>& sound) {
  return 10 * std::log10(std::inner_product(sound.begin(), sound.end(), sound.begin(), 0.0));
}

/// @param cents, decibels  by which pitches and levels may differ
void expect_alike(const SoundMap& joined, const SoundMap& whole, double cents, double decibels) {
  ASSERT_EQ(joined.modes(), whole.modes());
  EXPECT_NEAR(joined.mass, whole.mass, 1e-9 * whole.mass);
  EXPECT_LT((joined.centre - whole.centre).norm(), 1e-9);
  for (std::size_t mode = 0; mode < whole.modes(); ++mode) {
    const double pitch = 1200 * std::log2(joined.frequency[mode] / whole.frequency[mode]);
    const double loss = 10 * std::log10(joined.radiation_decay[mode] / whole.radiation_decay[mode]);
    EXPECT_NEAR(pitch, 0, cents) << mode;
    EXPECT_NEAR(loss, 0, decibels) << mode;
    EXPECT_NEAR(joined.material_decay[mode], whole.material_decay[mode], 1e-3 * whole.material_decay[mode]) << mode;
  }
  for (std::size_t listener = 0; listener < whole.listeners.size(); ++listener) {
    const double louder = sound_level(blow_sound(joined, listener)) - sound_level(blow_sound(whole, listener));
    EXPECT_NEAR(louder, 0, decibels) << listener;
  }
}

constexpr double bar_length = 0.24, bar_thickness = 0.01, bar_cell = 0.06;  // m
/// @param layers  of elements across the thickness
scene::Scene one_bar(int layers) {
  return scene_of(deck_of_bars(bar("bar", bar_length, bar_thickness, bar_cell, Vector3::Zero(), 4, layers), ""));
}

/// A bar that is cut at a quarter of its length and tied again.
/// @param order  of the elements of its longer part in the plane
scene::Scene tied_bar(int order) {
  constexpr double cut = bar_length / 4;
  return scene_of(deck_of_bars(bar("left", cut, bar_thickness, bar_cell, Vector3::Zero()) +
                                   bar("right", bar_length - cut, bar_thickness, bar_cell, {cut, 0, 0}, order),
                               "joints: {cut: {between: [left.tip, right.clamp], stiffness: rigid}}"));
}

ON_RANKS(1);

TEST(JoinedMap, ABarThatIsCutAndTiedSoundsAsInOnePiece) {
  const SoundMap tied = heard_map(tied_bar(4), Air::sphere_patches, 3);
  const SoundMap whole = heard_map(one_bar(1), Air::sphere_patches, 3);
  expect_alike(tied, whole, 1.5, 0.3);  // the tie gives way by b/(100 L)
}

TEST(JoinedMap, ABarThatIsGluedOfTwoSoundsAsInOnePiece) {
  const double half = bar_thickness / 2;
  const scene::Scene glued = scene_of(deck_of_bars(
      bar("upper", bar_length, half, bar_cell, {0, 0, half / 2}) +
          bar("lower", bar_length, half, bar_cell, {0, 0, -half / 2}),
      "joints: {glue: {between: [upper.bottom, lower.top], stiffness: {normal: 1.0e15, tangential: 1.0e15}}}"));
  const scene::Scene whole = one_bar(2);
  for (const Air air : {Air::boundary_elements, Air::sphere_patches}) {
    expect_alike(heard_map(glued, air, 3), heard_map(whole, air, 3), 0.5, 0.03);
  }
}

TEST(JoinedMap, HasNoBoundaryElementsWhereMeshesDoNotMeet) {
  const scene::Scene tied = tied_bar(3);
  SoundMap map = solid_map(tied, 0, {.count = 1}, eigenmodes::Estimates::none);
  const SolidRadiation chosen = solid_radiation(map, tied.radiation, std::nullopt);
  EXPECT_EQ(chosen.name, "kirchhoff");
  EXPECT_THAT(chosen.doubt, ::testing::HasSubstr("open at the borders of joints"));
  EXPECT_THROW((void)solid_radiation(map, tied.radiation, SurfaceModel::boundary_elements), std::invalid_argument);
  EXPECT_THROW((void)add_air_mass(map), std::runtime_error);
}

}  // namespace
}  // namespace idiophone::sound_maps
