// Mistakes of any section: keys, kinds of values, ranges, names.

#include <fmt/format.h>

#include "mistaken.hpp"

namespace idiophone::scene {

TEST_F(Mistaken, Keys) {
  expect({
      {"young", "yuong",
       "deck.yaml:4:10: materials.steel: the key 'young' is missing\n"
       "deck.yaml:4:11: materials.steel.yuong: unknown key (did you mean 'young'?), known here: from, young, "
       "poisson, shear, stiffness, density, damping, expansion"},
      {"time:", "Tiem:",
       "deck.yaml:1:1: the key 'time' is missing\n"
       "deck.yaml:2:1: Tiem: unknown key (did you mean 'time'?), known here: name, time, materials, bodies, obstacles, "
       "contacts, loads, joints, gauges, gravity, listeners, audio, radiation, output, references"},
      {"fixed: [rim]", "xyzzy: [rim]",
       "deck.yaml:6:45: bodies.plate.xyzzy: unknown key, known here: mesh, object, parameters, meshing, rotation, "
       "position, "
       "element, "
       "order, mass_scaling, thickness, material, materials, layers, grain, fixed, "
       "hinges, driven, groups, supports, model, fracture, prestress, springs, velocity, spin"},
      {"density: 7850", "density: 7850, young: 7",
       "deck.yaml:4:55: materials.steel.young: is said twice, first at deck.yaml:4:11; leave one out"},
      {"listeners:", "time: {duration: 2}\nlisteners:",
       "deck.yaml:9:1: time: is said twice, first at deck.yaml:2:1; leave one out"},
      {"duration: 1.0}", "duration: 1.0, [a]: 3}", "deck.yaml:2:23: time.?: a key is a name, found something else"},
      {"name: plate", "name: plate\n<<: {}",
       "deck.yaml:2:1: <<: unknown key, known here: name, time, materials, bodies, obstacles, contacts, loads, "
       "joints, gauges, gravity, listeners, "
       "audio, radiation, output, references"},
      {", poisson: 0.3", "", "deck.yaml:4:10: materials.steel: the key 'poisson' is missing"},
      {"mesh: plate.geo, material: steel, ", "",
       "deck.yaml:6:10: bodies.plate: the key 'mesh' is missing\n"
       "deck.yaml:6:10: bodies.plate: the key 'material' is missing"},
      {"fixed: [rim]", "meshing: {gap: 1}",
       "deck.yaml:6:55: bodies.plate.meshing.gap: has no meaning without repair: wrap"},
      {"fixed: [rim]", "meshing: {repair: wrap}",
       "deck.yaml:6:55: bodies.plate.meshing.repair: has no meaning: a .geo file is no surface of triangles, as .stl, "
       ".obj, .ply, .gltf, .glb, .fbx files are"},
  });
}

TEST_F(Mistaken, KindsOfValues) {
  expect({
      {"2.0e11", "steel", "deck.yaml:4:18: materials.steel.young: expected a number (Pa), found 'steel'"},
      {"2.0e11", "'2'", "deck.yaml:4:18: materials.steel.young: expected a number (Pa), found \"2\""},
      {"7850", "[1, 2]", "deck.yaml:4:49: materials.steel.density: expected a number (kg/m3), found a list of 2"},
      {"2.0e11", "{a: 1}", "deck.yaml:4:18: materials.steel.young: expected a number (Pa), found a map"},
      {"2.0e11", "", "deck.yaml:4:11: materials.steel.young: expected a number (Pa), found nothing"},
      {"2.0e11", "~", "deck.yaml:4:11: materials.steel.young: expected a number (Pa), found nothing"},
      {"2.0e11", ".nan", "deck.yaml:4:18: materials.steel.young: expected a number (Pa), found '.nan'"},
      {"2.0e11", ".inf", "deck.yaml:4:18: materials.steel.young: expected a number (Pa), found '.inf'"},
      {"2.0e11", "inf", "deck.yaml:4:18: materials.steel.young: expected a number (Pa), found 'inf'"},
      {"2.0e11", "nan", "deck.yaml:4:18: materials.steel.young: expected a number (Pa), found 'nan'"},
      {"2.0e11", "1e999", "deck.yaml:4:18: materials.steel.young: expected a number (Pa), found '1e999'"},
      {"2.0e11", "200 GPa", "deck.yaml:4:18: materials.steel.young: expected a number (Pa), found '200 GPa'"},
      {"2.0e11", "0x10", "deck.yaml:4:18: materials.steel.young: expected a number (Pa), found '0x10'"},
      {"2.0e11", "+-1", "deck.yaml:4:18: materials.steel.young: expected a number (Pa), found '+-1'"},
      {"2.0e11", "!!float 2",
       "deck.yaml:4:18: materials.steel.young: has the tag 'tag:yaml.org,2002:float'; decks know no tags"},
      {"[0, 0, 1]", "[0, 1]",
       "deck.yaml:10:31: listeners.ear.position: expected a list of 3 numbers (m), e.g. [0, 0, 1], found a list of 2"},
      {"[0, 0, 1]", "1",
       "deck.yaml:10:31: listeners.ear.position: expected a list of 3 numbers (m), e.g. [0, 0, 1], found '1'"},
      {"[0, 0, 1]", "[x, 0, .inf]",
       "deck.yaml:10:32: listeners.ear.position.0: expected a number (m), found 'x'\n"
       "deck.yaml:10:38: listeners.ear.position.2: expected a number (m), found '.inf'"},
      {"{duration: 1.0}", "1.0", "deck.yaml:2:7: time: expected a map of keys, found '1.0'"},
      {"{duration: 1.0}", "", "deck.yaml:2:1: time: expected a map of keys, found nothing"},
      {"[rim]", "rim", "deck.yaml:6:52: bodies.plate.fixed: expected a list, found 'rim'"},
      {"[rim]", "[[rim]]", "deck.yaml:6:53: bodies.plate.fixed.0: expected text, found a list of 1"},
      {"{mesh: plate.geo, material: steel, fixed: [rim]}", "[a, b]",
       "deck.yaml:6:10: bodies.plate: expected a map of keys, found a list of 2"},
      {"name: plate", "name: [plate]", "deck.yaml:1:7: name: expected text, found a list of 1"},
      {"name: plate", "name: ''", "deck.yaml:1:7: name: expected text, found \"\""},
  });
}

TEST_F(Mistaken, Ranges) {
  expect({
      {"2.0e11", "0", "deck.yaml:4:18: materials.steel.young: must be at least 1 and at most 1e+15 Pa, found 0"},
      {"2.0e11", "1e300",
       "deck.yaml:4:18: materials.steel.young: must be at least 1 and at most 1e+15 Pa, found 1e300"},
      {"poisson: 0.3", "poisson: 0.5",
       "deck.yaml:4:35: materials.steel.poisson: must be at least -0.9999 and at most 0.4999, found 0.5"},
      {"poisson: 0.3", "poisson: -1",
       "deck.yaml:4:35: materials.steel.poisson: must be at least -0.9999 and at most 0.4999, found -1"},
      {"7850", "-7850",
       "deck.yaml:4:49: materials.steel.density: must be at least 0.001 and at most 1000000 kg/m3, found -7850"},
      {"7850", "1, damping: {mass: -1, stiffness: -2}",
       "deck.yaml:4:68: materials.steel.damping.mass: must be at least 0 and at most 1e+09 1/s, found -1\n"
       "deck.yaml:4:83: materials.steel.damping.stiffness: must be at least 0 and at most 0.01 s, found -2"},
      {"duration: 1.0}", "duration: -1}",
       "deck.yaml:2:18: time.duration: must be above 0 and at most 86400 s, found -1"},
      {"duration: 1.0}", "duration: 1, safety: 0}",
       "deck.yaml:2:29: time.safety: must be above 0 and at most 1, found 0"},
      {"duration: 1.0}", "duration: 1, safety: 1.01}",
       "deck.yaml:2:29: time.safety: must be above 0 and at most 1, found 1.01"},
      {"duration: 1.0}", "duration: 1, steps_per_sample: 2.5}",
       "deck.yaml:2:39: time.steps_per_sample: expected a whole number, found '2.5'"},
      {"duration: 1.0}", "duration: 1, steps_per_sample: 0}",
       "deck.yaml:2:39: time.steps_per_sample: must be at least 1 and at most 100000, found 0"},
      {"duration: 1.0}", "duration: 1, wall_clock_limit: 0}",
       "deck.yaml:2:39: time.wall_clock_limit: must be above 0 and at most 1e+09 s, found 0"},
      {"[0, 0, -20]", "[0, 0, 0]", "deck.yaml:8:31: loads.tap.force: is zero; a load needs a force (N)"},
      {"duration: 1.0e-3", "duration: -1.0e-3",
       "deck.yaml:8:54: loads.tap.duration: must be above 0 and at most 1000000 s, found -1.0e-3"},
      {"[0, 0, 1]", "[0, 0, 1e7]",
       "deck.yaml:10:38: listeners.ear.position.2: must be at least -10000 and at most 10000 m, found 1e7"},
  });
}

TEST_F(Mistaken, NumbersThatWouldOverflowLater) {
  expect({
      {"7850", "1e-300",
       "deck.yaml:4:49: materials.steel.density: must be at least 0.001 and at most 1000000 kg/m3, found 1e-300"},
      {"7850", "1e-320",
       "deck.yaml:4:49: materials.steel.density: must be at least 0.001 and at most 1000000 kg/m3, found 1e-320"},
      {"7850", "7850, damping: {stiffness: 1e3}",
       "deck.yaml:4:76: materials.steel.damping.stiffness: must be at least 0 and at most 0.01 s, found 1e3"},
      {"poisson: 0.3", "poisson: 0.4999999999999999",
       "deck.yaml:4:35: materials.steel.poisson: must be at least -0.9999 and at most 0.4999, found "
       "0.4999999999999999"},
      {"duration: 1.0}", "duration: 1, steps_per_sample: 100001}",
       "deck.yaml:2:39: time.steps_per_sample: must be at least 1 and at most 100000, found 100001"},
      {"[0, 0, 1]", "[1e6, 0, 1]",
       "deck.yaml:10:32: listeners.ear.position.0: must be at least -10000 and at most 10000 m, found 1e6"},
  });
  expect_after({
      {"radiation: {air: {speed: 1e-300}}",
       "deck.yaml:11:26: radiation.air.speed: must be at least 50 and at most 100000 m/s, found 1e-300"},
      {"radiation: {air: {speed: 1e-10}}",
       "deck.yaml:11:26: radiation.air.speed: must be at least 50 and at most 100000 m/s, found 1e-10"},
      {"radiation: {air: {density: 1e-300}}",
       "deck.yaml:11:28: radiation.air.density: must be at least 1e-06 and at most 10000 kg/m3, found 1e-300"},
      {"audio: {max_frequency: 440}",
       "deck.yaml:11:24: audio.max_frequency: must be at least 441 and at most 22050 Hz, found 440"},
      {"audio: {kernel_wavelengths: 33}",
       "deck.yaml:11:29: audio.kernel_wavelengths: must be at least 1 and at most 32, found 33"},
  });
}

TEST_F(Mistaken, Names) {
  const std::string rule =
      "can't name a file and a dataset; use 1 to 64 letters (a-z, A-Z), digits, - and _, not beginning with -";
  const std::string too_long(65, 'x');
  expect({
      {"name: plate", "name: a/b", "deck.yaml:1:7: 'a/b' " + rule},
      {"name: plate", "name: ..", "deck.yaml:1:7: '..' " + rule},
      {"name: plate", "name: -plate", "deck.yaml:1:7: '-plate' " + rule},
      {"name: plate", "name: " + too_long, fmt::format("deck.yaml:1:7: '{}' {}", too_long, rule)},
      {"  ear:", "  left ear:", "deck.yaml:10:3: 'left ear' " + rule},
      {"  tap:", "  tap.1:", "deck.yaml:8:3: 'tap.1' " + rule},
      {"  ear:", "  '':",
       "deck.yaml:10:3: listeners.?: a key is a name, found something else\n"
       "deck.yaml:10:3: listeners: is empty; it needs at least one entry"},
      {"tap: {", "tap: {body: platte, ",
       "deck.yaml:8:15: loads.tap.body: must be one of plate, found 'platte' (did you mean 'plate'?)"},
      {"tap: {", "tap: {type: pulck, ",
       "deck.yaml:8:15: loads.tap.type: must be one of pulse, pluck, wind, bow, found 'pulck' (did you mean 'pulse'?)"},
      {"mono", "quadro", "deck.yaml:10:15: listeners.ear.type: must be one of mono, stereo, binaural, found 'quadro'"},
  });
}

TEST_F(Mistaken, WhatNeedsABodyThatIsFree) {
  const std::string held =
      "deck.yaml:8:62: loads.tap.balanced: has no meaning here: body 'plate' is held and does not move "
      "as a whole";
  EXPECT_EQ(mistakes(replaced(plate, "1.0e-3}", "1.0e-3, balanced: true}")), held);
  EXPECT_EQ(mistakes(replaced(replaced(plate, "1.0e-3}", "1.0e-3, balanced: true}"), ", fixed: [rim]", "")),
            "no mistakes");
  const std::string creeping = replaced(plate, "7850", "7850, damping: {mass: 1, mass_of: vibration}");
  EXPECT_EQ(mistakes(creeping), "no mistakes");
  EXPECT_THAT(mistakes(replaced(creeping, "tap: {", "tap: {type: pluck, ")), testing::HasSubstr("Take mass_of: all"));
}

TEST_F(Mistaken, EmptyMaps) {
  const std::string listener = "listeners:\n  ear: {type: mono, position: [0, 0, 1]}\n";
  expect({
      {listener, "", "deck.yaml:1:1: the key 'listeners' is missing"},
      {listener, "listeners: {}\n", "deck.yaml:9:12: listeners: is empty; it needs at least one entry"},
      {listener, "listeners:\n", "deck.yaml:9:1: listeners: expected a map of names, found nothing"},
      {"  plate: {mesh: plate.geo, material: steel, fixed: [rim]}", "  {}",
       "deck.yaml:6:3: bodies: is empty; it needs at least one entry"},
      {"  tap: {at: [0, 0, 0], force: [0, 0, -20], duration: 1.0e-3}", "  [a]",
       "deck.yaml:8:3: loads: expected a map of names, found a list of 1"},
  });
}

TEST_F(Mistaken, AllAtOnceInTheOrderOfTheLines) {
  const std::string deck = replaced(replaced(replaced(plate, "7850", "-1"), "[0, 0, -20]", "[0, 0]"), "duration: 1.0}",
                                    "duration: long, saftey: 1}");
  EXPECT_EQ(
      mistakes(deck),
      "deck.yaml:2:18: time.duration: expected a number (s), found 'long'\n"
      "deck.yaml:2:24: time.saftey: unknown key (did you mean 'safety'?), known here: duration, steps_per_sample, "
      "safety, wall_clock_limit\n"
      "deck.yaml:4:49: materials.steel.density: must be at least 0.001 and at most 1000000 kg/m3, found -1\n"
      "deck.yaml:8:31: loads.tap.force: expected a list of 3 numbers (N), e.g. [0, 0, 1], found a list of 2");
}

}  // namespace idiophone::scene
