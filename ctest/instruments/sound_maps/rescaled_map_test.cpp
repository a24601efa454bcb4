// Maps for another material against maps whose modes are solved for it.

#include "idiophone/instruments/sound_maps/rescaled_map.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "idiophone/instruments/sound_maps/modal_radiation.hpp"
#include "idiophone/instruments/sound_maps/solid_map.hpp"
#include "idiophone/scene/resolved_deck.hpp"
#include "ranks.hpp"
#include "shared_folder.hpp"

namespace idiophone::sound_maps {
namespace {

using ::testing::HasSubstr;
using Overrides = std::vector<std::string>;

constexpr const char* tongue = IDIOPHONE_SOURCE_DIR "/ctest/app/decks/tongue.yaml";

/// By a solution for the modes, with the radiation of sphere patches.
SoundMap solved(const Overrides& overrides) {
  const scene::Scene scene = scene::read_deck(tongue, overrides);
  SoundMap map = solid_map(scene, 0, {.count = 5}, eigenmodes::Estimates::none);
  map.resolved_deck = scene::resolved_deck(tongue, overrides);
  map.sphere = sphere_of_directions(4);
  add_radiation(map, scene, sphere_patches(map, scene.radiation), MPI_COMM_SELF);
  return map;
}

/// The map of the deck as it is.
const SoundMap& original() {
  static const SoundMap map = solved({});
  return map;
}

SoundMap rescaled(const SoundMap& source, const Overrides& overrides) {
  const scene::Scene scene = scene::read_deck(tongue, overrides);
  return rescaled_map(source, "source.map.h5", scene, 0, scene::resolved_deck(tongue, overrides));
}

template <class Numbers>
void expect_near(const Numbers& numbers, const Numbers& expected, double tolerance) {
  ASSERT_EQ(numbers.size(), expected.size());
  const auto size = [](auto number) { return std::abs(number); };
  const double largest = std::abs(*std::ranges::max_element(expected, {}, size));
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    ASSERT_LE(std::abs(numbers[i] - expected[i]), tolerance * largest) << i;
  }
}

void expect_same_modes(const SoundMap& map, const SoundMap& expected) {
  EXPECT_NEAR(map.mass, expected.mass, 1e-12 * expected.mass);
  EXPECT_EQ(map.material->density, expected.material->density);
  expect_near(map.frequency, expected.frequency, 1e-9);
  expect_near(map.material_decay, expected.material_decay, 1e-9);
  expect_near(map.shape, expected.shape, 1e-5);
}

ON_RANKS(1);

TEST(RescaledMap, HasTheModesOfASolutionForTheNewMaterial) {
  const SoundMap& source = original();
  const Overrides heavier = {"materials.rubber.young=3e8", "materials.rubber.density=2000",
                             "materials.rubber.damping={mass: 7, loss_factor: 0.02, mass_of: vibration}"};
  const SoundMap map = rescaled(source, heavier);
  expect_same_modes(map, solved(heavier));
  EXPECT_TRUE(map.sphere.pressure.empty());
  EXPECT_TRUE(map.listeners.empty());
  const SoundMap back = rescaled(map, {});
  expect_same_modes(back, source);
}

TEST(RescaledMap, HasTheModesOfWoodWithOtherConstants) {
  const auto wood = [](double factor, double density) -> Overrides {
    return {"materials.wood={young: [" + std::to_string(factor * 1e9) + ", 8e8, 5e8], poisson: [0.3, 0.4, 0.3], " +
                "shear: [7e8, 4e7, 6e8], density: " + std::to_string(density) + ", damping: {stiffness: 1e-6}}",
            "bodies.tongue.material=wood"};
  };
  const auto doubled = [&](double density) {
    Overrides overrides = wood(20, density);
    overrides.front().replace(overrides.front().find("8e8, 5e8"), 8, "1.6e9,1e9");
    overrides.front().replace(overrides.front().find("7e8, 4e7, 6e8"), 13, "1.4e9,8e7,1.2e9");
    return overrides;
  };
  const SoundMap source = solved(wood(10, 400));
  expect_same_modes(rescaled(source, doubled(500)), solved(doubled(500)));
  EXPECT_THAT(support::error_of([&] { (void)rescaled(source, wood(20, 400)); }), HasSubstr("times one factor"));
}

TEST(RescaledMap, KeepsTheRadiationWhereTheFrequenciesStay) {
  const SoundMap& source = original();
  const SoundMap damped = rescaled(source, {"materials.rubber.damping={mass: 7}"});
  EXPECT_EQ(damped.frequency, source.frequency);
  EXPECT_EQ(damped.sphere.pressure, source.sphere.pressure);
  EXPECT_EQ(damped.radiation_decay, source.radiation_decay);
  EXPECT_EQ(damped.material_decay, std::vector<double>(5, 3.5));

  const Overrides both = {"materials.rubber.young=2e8", "materials.rubber.density=4400"};
  const SoundMap heavy = rescaled(source, both);
  const SoundMap expected = solved(both);
  expect_same_modes(heavy, expected);
  expect_near(heavy.sphere.pressure, expected.sphere.pressure, 1e-5);
  expect_near(heavy.listeners.at(0).pressure, expected.listeners.at(0).pressure, 1e-5);
  expect_near(heavy.radiation_decay, expected.radiation_decay, 1e-5);

  for (const char* changed : {"listeners.ear.position=[0, 0, 0.4]", "radiation.air={speed: 340}",
                              "radiation.floor={at: [0, 0, -1]}", "materials.rubber.density=1200"}) {
    EXPECT_TRUE(rescaled(source, {changed}).sphere.pressure.empty()) << changed;
  }
}

/// The tongue with all lengths times a factor, and others besides.
Overrides sized(double factor, const Overrides& others = {}) {
  Overrides overrides = others;
  for (const auto& [name, length] :
       std::map<std::string, double>{{"length", 0.2}, {"width", 0.05}, {"thickness", 0.03}, {"size", 0.05}}) {
    overrides.push_back(fmt::format("bodies.tongue.parameters.{}={:.17g}", name, factor * length));
  }
  return overrides;
}

TEST(RescaledMap, HasTheModesOfASolutionForAnotherSize) {
  const SoundMap& source = original();
  for (const double factor : {0.5, 1.3}) {
    const Overrides other = sized(factor, {"bodies.tongue.position=[0.1, 0.2, 0.3]", "materials.rubber.density=2000",
                                           "materials.rubber.damping={mass: 7, stiffness: 1e-7}"});
    const SoundMap map = rescaled(source, other), expected = solved(other);
    expect_same_modes(map, expected);
    EXPECT_TRUE(map.sphere.pressure.empty());
    EXPECT_LT((map.centre - expected.centre).norm(), 1e-9);
    ASSERT_EQ(map.triangles, expected.triangles);
    for (std::size_t vertex = 0; vertex < map.vertices.size(); ++vertex) {
      ASSERT_LT((map.vertices[vertex] - expected.vertices[vertex]).norm(), 1e-9);
    }
    expect_same_modes(rescaled(map, {}), source);
  }
}

TEST(RescaledMap, KeepsTheRadiationOfAnotherSizeAtPlacesThatGoWithIt) {
  const SoundMap& source = original();
  const auto larger = [](const std::string& position, const Overrides& others = {}) {
    Overrides overrides = sized(1.3, others);
    overrides.push_back("bodies.tongue.position=[1, 0, 0]");
    overrides.push_back("listeners.ear.position=" + position);
    return overrides;
  };
  const Overrides along = larger("[1, 0, 0.39]", {"materials.rubber.damping={mass: 7}"});
  const SoundMap map = rescaled(source, along), expected = solved(along);
  expect_same_modes(map, expected);
  expect_near(map.sphere.pressure, expected.sphere.pressure, 1e-5);
  expect_near(map.radiation_decay, expected.radiation_decay, 1e-5);
  expect_near(map.listeners.at(0).pressure, expected.listeners.at(0).pressure, 1e-5);
  EXPECT_NEAR(map.listeners[0].delay, expected.listeners[0].delay, 1e-9 * map.listeners[0].delay);
  EXPECT_LT((map.listeners[0].position - expected.listeners[0].position).norm(), 1e-9);

  for (const auto& [position, other] :
       {std::pair("[0, 0, 0.39]", "materials.rubber.density=1100"),
        std::pair("[1, 0, 0.39]", "materials.rubber.density=1000"),
        std::pair("[1, 0, 0.39]", "radiation.air.absorption=true"),
        std::pair("[1, 0, 0.39]", "listeners.ear={type: mono, position: [0, 0, 0], pattern: 0.5, look: [0, 0, -1]}")}) {
    EXPECT_TRUE(rescaled(source, larger(position, {other})).sphere.pressure.empty()) << position << other;
  }
}

TEST(RescaledMap, RefusesWhatTurned) {
  // The mesh looks the same after half a turn, but for what is held.
  for (const auto& [fixed, degrees] :
       {std::pair("bodies.tongue.fixed=[]", 90), std::pair("bodies.tongue.fixed=[clamp]", 180)}) {
    const Overrides turned = {fixed, fmt::format("bodies.tongue.rotation={{axis: [0, 0, 1], degrees: {}}}", degrees)};
    EXPECT_THAT(support::error_of([&] { (void)rescaled(solved({fixed}), turned); }),
                HasSubstr("not this one times a factor"))
        << fixed;
  }
}

TEST(RescaledMap, RefusesWhatDoesNotScale) {
  SoundMap source = original();
  const auto refusal = [&](const std::string& changed) {
    return support::error_of([&] { (void)rescaled(source, {changed}); });
  };
  EXPECT_THAT(refusal("materials.rubber.poisson=0.3"), HasSubstr("Poisson's ratio"));
  EXPECT_THAT(refusal("bodies.tongue.parameters.thickness=0.02"),
              HasSubstr("and it is not this one times a factor; make"));
  EXPECT_THAT(refusal("bodies.tongue.fixed=[{group: clamp, axes: xz}]"),
              HasSubstr("what holds it is 'clamp xz', and 'clamp xyz' in source.map.h5"));
  EXPECT_THAT(refusal("bodies.tongue.supports={foot: {at: [0.1, 0, 0.015], radius: 0.06, stiffness: 1e4}}"),
              HasSubstr("it has supports"));
  EXPECT_THAT(refusal("bodies.tongue.prestress={xx: 1e5}"), HasSubstr("it has a prestress"));
  source.scalable.reset();
  EXPECT_THAT(refusal("materials.rubber.density=1200"), HasSubstr("does not say what its modes depend on"));
}

TEST(RescaledMap, IsNoneOfABodyWhoseModesDependOnMoreThanItsMaterial) {
  EXPECT_TRUE(original().scalable.has_value());
  EXPECT_FALSE(solved({"bodies.tongue.supports={foot: {at: [0.1, 0, 0.015], radius: 0.06, stiffness: 1e4}}"}).scalable);
}

}  // namespace
}  // namespace idiophone::sound_maps
