// Decks with a mistake, and exactly how each is answered.

#include "deck_fixture.hpp"

namespace idiophone::scene {

namespace {

/// The small deck with one text replaced by another, and the answer.
struct Wrong {
  std::string old;
  std::string by;
  std::string answer;
};

}  // namespace

class Mistaken : public DeckTest {
 protected:
  void expect(const std::vector<Wrong>& decks) const {
    for (const Wrong& wrong : decks) {
      SCOPED_TRACE(wrong.old + " -> " + wrong.by);
      ASSERT_NE(plate.find(wrong.old), std::string::npos);
      EXPECT_EQ(mistakes(replaced(plate, wrong.old, wrong.by)), wrong.answer);
    }
  }

  /// The same for text added at the end.
  void expect_after(const std::vector<std::pair<std::string, std::string>>& ends) const {
    for (const auto& [end, answer] : ends) {
      SCOPED_TRACE(end);
      EXPECT_EQ(mistakes(plate + end), answer);
    }
  }
};

TEST_F(Mistaken, Keys) {
  expect({
      {"young", "yuong",
       "deck.yaml:4:10: materials.steel: the key 'young' is missing\n"
       "deck.yaml:4:11: materials.steel.yuong: unknown key (did you mean 'young'?), known here: from, young, "
       "poisson, shear, density, damping"},
      {"time:", "Tiem:",
       "deck.yaml:1:1: the key 'time' is missing\n"
       "deck.yaml:2:1: Tiem: unknown key (did you mean 'time'?), known here: name, time, materials, bodies, obstacles, "
       "contacts, loads, gravity, listeners, audio, radiation, output, references"},
      {"fixed: [rim]", "xyzzy: [rim]",
       "deck.yaml:6:45: bodies.plate.xyzzy: unknown key, known here: mesh, parameters, meshing, rotation, position, "
       "element, "
       "order, mass_scaling, thickness, material, grain, fixed, "
       "hinges, driven, supports, velocity, spin"},
      {"density: 7850", "density: 7850, young: 7",
       "deck.yaml:4:55: materials.steel.young: is said twice, first at deck.yaml:4:11; leave one out"},
      {"listeners:", "time: {duration: 2}\nlisteners:",
       "deck.yaml:9:1: time: is said twice, first at deck.yaml:2:1; leave one out"},
      {"duration: 1.0}", "duration: 1.0, [a]: 3}", "deck.yaml:2:23: time.?: a key is a name, found something else"},
      {"name: plate", "name: plate\n<<: {}",
       "deck.yaml:2:1: <<: unknown key, known here: name, time, materials, bodies, obstacles, contacts, loads, "
       "gravity, listeners, "
       "audio, radiation, output, references"},
      {", poisson: 0.3", "", "deck.yaml:4:10: materials.steel: the key 'poisson' is missing"},
      {"mesh: plate.geo, material: steel, ", "",
       "deck.yaml:6:10: bodies.plate: the key 'mesh' is missing\n"
       "deck.yaml:6:10: bodies.plate: the key 'material' is missing"},
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

TEST_F(Mistaken, Names) {
  const std::string rule =
      "can't name a file and a dataset; use 1 to 64 letters (a-z, A-Z), digits, - and _, not beginning with -";
  expect({
      {"name: plate", "name: a/b", "deck.yaml:1:7: 'a/b' " + rule},
      {"name: plate", "name: ..", "deck.yaml:1:7: '..' " + rule},
      {"name: plate", "name: -plate", "deck.yaml:1:7: '-plate' " + rule},
      {"name: plate", "name: " + std::string(65, 'x'), "deck.yaml:1:7: '" + std::string(65, 'x') + "' " + rule},
      {"  ear:", "  left ear:", "deck.yaml:10:3: 'left ear' " + rule},
      {"  tap:", "  tap.1:", "deck.yaml:8:3: 'tap.1' " + rule},
      {"  ear:", "  '':",
       "deck.yaml:10:3: listeners.?: a key is a name, found something else\n"
       "deck.yaml:10:3: listeners: is empty; it needs at least one entry"},
      {"tap: {", "tap: {body: platte, ",
       "deck.yaml:8:15: loads.tap.body: must be one of plate, found 'platte' (did you mean 'plate'?)"},
      {"tap: {", "tap: {type: pulck, ",
       "deck.yaml:8:15: loads.tap.type: must be one of pulse, pluck, found 'pulck' (did you mean 'pulse'?)"},
      {"mono", "quadro", "deck.yaml:10:15: listeners.ear.type: must be one of mono, stereo, binaural, found 'quadro'"},
  });
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

TEST_F(Mistaken, Files) {
  expect({
      {"plate.geo", "plaet.geo", "deck.yaml:6:17: bodies.plate.mesh: no such file: DIR/plaet.geo"},
      {"plate.geo", "shapes", "deck.yaml:6:17: bodies.plate.mesh: expected a file, found the folder DIR/shapes"},
      {"plate.geo", "../nowhere/x.msh",
       "deck.yaml:6:17: bodies.plate.mesh: no such file: " + (folder.parent_path() / "nowhere/x.msh").string()},
      {"plate.geo", "deck.yaml",
       "deck.yaml:6:17: bodies.plate.mesh: must end in .geo, .msh, .step, .stp, .brep, .stl, .obj, found 'deck.yaml'"},
      {"plate.geo", "shapes/bar.msh, parameters: {side: 1}",
       "deck.yaml:6:33: bodies.plate.parameters: a .msh file is a mesh already and has no parameters; leave them out"},
      {"plate.geo", "plate.geo, parameters: {side: one}",
       "deck.yaml:6:47: bodies.plate.parameters.side: expected a number, found 'one'"},
      {"plate.geo", "plate.geo, parameters: [1]",
       "deck.yaml:6:40: bodies.plate.parameters: expected a map of numbers, found a list of 1"},
  });
}

TEST_F(Mistaken, Constraints) {
  expect({
      {"[rim]", "[{group: rim, axes: xx}]",
       "deck.yaml:6:72: bodies.plate.fixed.0.axes: expected some of the letters xyz, each once, e.g. xz; found 'xx'"},
      {"[rim]", "[{group: rim, axes: w}]",
       "deck.yaml:6:72: bodies.plate.fixed.0.axes: expected some of the letters xyz, each once, e.g. xz; found 'w'"},
      {"[rim]", "[{axes: x}]", "deck.yaml:6:53: bodies.plate.fixed.0: the key 'group' is missing"},
      {"[rim]", "[{group: rim, axes: xz}, {group: rim, axes: z}]",
       "deck.yaml:6:77: bodies.plate: z of the group 'rim' is fixed, hinged or driven more than once"},
      {"fixed: [rim]", "driven: [{group: rim, displacement: [0, 0, 0], duration: 1}]",
       "deck.yaml:6:81: bodies.plate.driven.0.displacement: needs a displacement (m) or a rotation that is not zero; a "
       "group that is held still belongs under fixed"},
      {"fixed: [rim]", "driven: [{group: rim, displacement: [1, 0, 2], axes: z, duration: 1}]",
       "deck.yaml:6:82: bodies.plate.driven.0.displacement.0: must be 0, for axes leaves this direction free"},
      {"fixed: [rim]", "driven: [{group: rim, duration: 1}]",
       "deck.yaml:6:54: bodies.plate.driven.0: needs a displacement (m) or a rotation that is not zero; a group that "
       "is "
       "held still belongs under fixed"},
      {"[rim]", "[rim], hinges: [rim]",
       "deck.yaml:6:68: bodies.plate: x of the group 'rim' is fixed, hinged or driven more than once\n"
       "deck.yaml:6:68: bodies.plate: y of the group 'rim' is fixed, hinged or driven more than once\n"
       "deck.yaml:6:68: bodies.plate: z of the group 'rim' is fixed, hinged or driven more than once"},
      {"fixed: [rim]", "hinges: axle", "deck.yaml:6:53: bodies.plate.hinges: expected a list, found 'axle'"},
      {"fixed: [rim]", "hinges: [{group: axle}]", "deck.yaml:6:54: bodies.plate.hinges.0: expected text, found a map"},
      {"fixed: [rim]", "supports: {cord: {at: [0, 0, 0]}}",
       "deck.yaml:6:62: bodies.plate.supports.cord: a support needs a stiffness (N/m) or a damping (N s/m) above 0"},
      {"fixed: [rim]", "supports: {cord: {stiffness: -1}}",
       "deck.yaml:6:62: bodies.plate.supports.cord: the key 'at' is missing\n"
       "deck.yaml:6:74: bodies.plate.supports.cord.stiffness: must be at least 0 and at most 1e+15 N/m, found -1"},
  });
}

TEST_F(Mistaken, Rotations) {
  const auto driven = [](const std::string& more) { return "driven: [{group: rim, duration: 1, " + more + "}]"; };
  const std::string turn = "rotation: {axis: [0, 0, 1], degrees: 5, pivot: [0, 0, 0]}";
  expect({
      {"fixed: [rim]", driven("rotation: {axis: [0, 0, 0], degrees: 5, pivot: [0, 0, 0]}"),
       "deck.yaml:6:97: bodies.plate.driven.0.rotation.axis: is zero; it must be a direction, e.g. [0, 0, -1]"},
      {"fixed: [rim]", driven("rotation: {axs: [0, 0, 1]}"),
       "deck.yaml:6:90: bodies.plate.driven.0.rotation: the key 'axis' is missing\n"
       "deck.yaml:6:90: bodies.plate.driven.0.rotation: the key 'degrees' is missing\n"
       "deck.yaml:6:90: bodies.plate.driven.0.rotation: the key 'pivot' is missing\n"
       "deck.yaml:6:91: bodies.plate.driven.0.rotation.axs: unknown key (did you mean 'axis'?), known here: axis, "
       "degrees, pivot"},
      {"fixed: [rim]", driven("rotation: {axis: [0, 0, 1], degrees: 0, pivot: [0, 0, 0]}"),
       "deck.yaml:6:54: bodies.plate.driven.0: needs a displacement (m) or a rotation that is not zero; a group that "
       "is "
       "held still belongs under fixed"},
      {"fixed: [rim]", driven("axes: xy, " + turn),
       "deck.yaml:6:86: bodies.plate.driven.0.axes: must be xyz, or left out: a group that turns is held in all "
       "directions"},
      {"fixed: [rim]", driven("rotation: 5"),
       "deck.yaml:6:90: bodies.plate.driven.0.rotation: expected a map of keys, found '5'"},
  });
}

TEST_F(Mistaken, Obstacles) {
  const auto obstacle = [](const std::string& name, const std::string& keys) {
    return "contacts: {a: {between: [plate, " + name + "]}}\nobstacles: {" + name + ": {" + keys + "}}";
  };
  expect_after({
      {obstacle("floor", "at: [0, 0, 0]"), "deck.yaml:12:20: obstacles.floor: the key 'shape' is missing"},
      {obstacle("floor", "shape: halfspace"),
       "deck.yaml:12:28: obstacles.floor.shape: must be one of half_space, box, sphere, cylinder, surface, found "
       "'halfspace' (did you mean 'half_space'?)"},
      {obstacle("floor", "shape: half_space, direction: [0, 0, 0]"),
       "deck.yaml:12:20: obstacles.floor: the key 'at' is missing\n"
       "deck.yaml:12:51: obstacles.floor.direction: is zero; it must be a direction, e.g. [0, 0, -1]"},
      {obstacle("floor", "shape: half_space, at: [0, 0, 0], radius: 1"),
       "deck.yaml:12:55: obstacles.floor.radius: unknown key, known here: shape, at, direction"},
      {obstacle("block", "shape: box, at: [0, 0, 0], size: [1, 0, -1]"),
       "deck.yaml:12:58: obstacles.block.size.1: must be above 0 and at most 1000000 m, found 0\n"
       "deck.yaml:12:61: obstacles.block.size.2: must be above 0 and at most 1000000 m, found -1"},
      {obstacle("block", "shape: box, at: [0, 0, 0], size: [1, 1, 1], rotation: {axis: [1, 0, 0], pivot: [0, 0, 0]}"),
       "deck.yaml:12:75: obstacles.block.rotation: the key 'degrees' is missing\n"
       "deck.yaml:12:93: obstacles.block.rotation.pivot: unknown key, known here: axis, degrees"},
      {obstacle("ball", "shape: sphere, at: [0, 0, 0]"),
       "deck.yaml:12:19: obstacles.ball: the key 'radius' is missing"},
      {obstacle("ball", "shape: sphere, at: [0, 0, 0], radius: 0"),
       "deck.yaml:12:58: obstacles.ball.radius: must be above 0 and at most 1000000 m, found 0"},
      {obstacle("post", "shape: cylinder, at: [0, 0, 0], radius: 1"),
       "deck.yaml:12:19: obstacles.post: the key 'length' is missing"},
      {obstacle("rock", "shape: surface, at: [0, 0, 0]"), "deck.yaml:12:19: obstacles.rock: the key 'mesh' is missing"},
      {obstacle("rock", "shape: surface, at: [0, 0, 0], mesh: deck.yaml"),
       "deck.yaml:12:57: obstacles.rock.mesh: must end in .geo, .msh, .step, .stp, .brep, .stl, .obj, found "
       "'deck.yaml'"},
      {obstacle("rock", "shape: surface, at: [0, 0, 0], mesh: shapes/bar.msh, parameters: {a: 1}"),
       "deck.yaml:12:73: obstacles.rock.parameters: a .msh file is a mesh already and has no parameters; leave them "
       "out"},
      {"obstacles: {plate: {shape: sphere, at: [0, 0, 0], radius: 1}}",
       "deck.yaml:11:13: obstacles.plate: a body is called 'plate' already; contacts could not tell the two apart, so "
       "choose another name\n"
       "deck.yaml:11:13: obstacles.plate: no contact names it, so everything would pass through it; add 'contacts: "
       "{NAME: {between: [BODY, plate]}}', or leave it out"},
      {"obstacles: [floor]", "deck.yaml:11:12: obstacles: expected a map of names, found a list of 1"},
  });
}

TEST_F(Mistaken, Contacts) {
  const auto contact = [](const std::string& keys) {
    return "obstacles: {floor: {shape: half_space, at: [0, 0, 0]}, wall: {shape: half_space, at: [0, 0, 0]}}\n"
           "contacts: {rest: {between: [wall, plate]}, c: {between: [plate, floor]" +
           keys + "}}";
  };
  const auto between = [&](const std::string& names) { return replaced(contact(""), "[plate, floor]", names); };
  expect_after({
      {"contacts: {c: {friction: 1}}", "deck.yaml:11:15: contacts.c: the key 'between' is missing"},
      {between("plate"),
       "deck.yaml:12:57: contacts.c.between: expected a list of 2 names, [BODY, BODY] or [BODY, OBSTACLE], found "
       "'plate'"},
      {between("[plate]"),
       "deck.yaml:12:57: contacts.c.between: expected a list of 2 names, [BODY, BODY] or [BODY, OBSTACLE], found a "
       "list "
       "of 1"},
      {between("[plte, flor]"),
       "deck.yaml:12:58: contacts.c.between.0: must be one of plate, floor, wall, found 'plte' (did you mean "
       "'plate'?)\n"
       "deck.yaml:12:64: contacts.c.between.1: must be one of plate, floor, wall, found 'flor' (did you mean "
       "'floor'?)"},
      {between("[floor, wall]"),
       "deck.yaml:12:57: contacts.c.between: names no body; obstacles stand still, so one of the two must be a body"},
      {between("[plate, plate]"),
       "deck.yaml:12:57: contacts.c.between: names 'plate' twice; a body's contact with itself is not computed"},
      {between("[plate, wall]"),
       "deck.yaml:11:13: obstacles.floor: no contact names it, so everything would pass through it; add 'contacts: "
       "{NAME: {between: [BODY, floor]}}', or leave it out\n"
       "deck.yaml:12:44: contacts.c: 'rest' at deck.yaml:12:12 is between the same two already; leave one out"},
      {contact(", friction: -1"), "deck.yaml:12:83: contacts.c.friction: must be at least 0 and at most 100, found -1"},
      {contact(", friction: {sticking: 0.3, sliding: 0.4}"),
       "deck.yaml:12:108: contacts.c.friction.sliding: must be at most sticking, which is 0.3, found 0.4"},
      {contact(", friction: {sliding: 0.4}"), "deck.yaml:12:83: contacts.c.friction: the key 'sticking' is missing"},
      {contact(", damping: -1"),
       "deck.yaml:12:82: contacts.c.damping: must be at least 0 and at most 1000 s, found -1"},
      {contact(", stiffness: 0"),
       "deck.yaml:12:84: contacts.c.stiffness: must be above 0 and at most 1e+24 Pa/m, found 0"},
      {contact(", stifness: 1"),
       "deck.yaml:12:73: contacts.c.stifness: unknown key (did you mean 'stiffness'?), known here: between, friction, "
       "damping, stiffness"},
  });
}

TEST_F(Mistaken, TwoContactsOfTwoBodies) {
  const std::string deck =
      replaced(replaced(plate, "bodies:\n", "bodies:\n  bar: {mesh: shapes/bar.msh, material: steel}\n"), "tap: {",
               "tap: {body: bar, ") +
      "contacts:\n  a: {between: [plate, bar]}\n  b: {between: [bar, plate]}\n";
  EXPECT_EQ(mistakes(deck),
            "deck.yaml:14:3: contacts.b: 'a' at deck.yaml:13:3 is between the same two already; leave one out");
}

TEST_F(Mistaken, Signals) {
  write("force.csv", "0, 0\n1e-3, 1\n");
  expect({
      {", duration: 1.0e-3", "", "deck.yaml:8:8: loads.tap: the key 'duration' is missing"},
      {"duration: 1.0e-3", "shape: sine", "deck.yaml:8:8: loads.tap: the key 'frequency' is missing"},
      {"duration: 1.0e-3", "shape: table", "deck.yaml:8:8: loads.tap: the key 'table' is missing"},
      {"duration: 1.0e-3", "shape: half_sin, duration: x",
       "deck.yaml:8:51: loads.tap.shape: must be one of half_sine, constant, sine, table, found 'half_sin' (did you "
       "mean "
       "'half_sine'?)"},
      {"duration: 1.0e-3", "shape: constant, frequency: 3",
       "deck.yaml:8:61: loads.tap.frequency: only 'shape: sine' has a frequency"},
      {"duration: 1.0e-3", "duration: 1, table: force.csv",
       "deck.yaml:8:57: loads.tap.table: only 'shape: table' has a table"},
      {"duration: 1.0e-3", "shape: table, table: force.csv, duration: 1",
       "deck.yaml:8:76: loads.tap.duration: a table ends with its last row; leave duration out"},
      {"duration: 1.0e-3", "type: pluck, start: 0",
       "deck.yaml:8:57: loads.tap.start: unknown key, known here: type, body, at, radius, force"},
      {"duration: 1.0e-3", "duration: 1, start: -1",
       "deck.yaml:8:64: loads.tap.start: must be at least 0 and at most 1000000 s, found -1"},
      {"duration: 1.0e-3", "shape: table, table: none.csv",
       "deck.yaml:8:65: loads.tap.table: no such file: DIR/none.csv"},
  });
}

TEST_F(Mistaken, Listeners) {
  expect({
      {"mono", "stereo",
       "deck.yaml:10:8: listeners.ear: the key 'look' is missing\ndeck.yaml:10:8: listeners.ear: the key 'up' is "
       "missing"},
      {"mono", "mono, up: [0, 0, 1]",
       "deck.yaml:10:21: listeners.ear.up: unknown key, known here: type, position, path, pattern, look"},
      {"mono", "stereo, look: [0, 0, 0], up: [0, 1, 0]",
       "deck.yaml:10:29: listeners.ear.look: is zero; it must be a direction, e.g. [0, 0, -1]"},
      {"mono", "stereo, look: [0, 1, 0], up: [0, 0, 0]",
       "deck.yaml:10:44: listeners.ear.up: is zero; it must be a direction, e.g. [0, 0, -1]"},
      {"mono", "stereo, look: [0, 0, -1], up: [0, 0, 2]",
       "deck.yaml:10:45: listeners.ear.up: is parallel to look; the ears' direction, look x up, is undefined"},
      {"mono", "stereo, look: [0, 0, -1], up: [0, 1, 0], separation: -1",
       "deck.yaml:10:68: listeners.ear.separation: must be at least 0 and at most 1000 m, found -1"},
      {"type: mono, ", "", "deck.yaml:10:8: listeners.ear: the key 'type' is missing"},
  });
}

TEST_F(Mistaken, Settings) {
  expect_after({
      {"audio: {rate: 44100.5}",
       "deck.yaml:11:15: audio.rate: expected a whole number (samples per second), found '44100.5'"},
      {"audio: {rate: 1e12}",
       "deck.yaml:11:15: audio.rate: must be at least 2000 and at most 1000000 samples per second, found 1e12"},
      {"audio: {rate: 8000, max_frequency: 4001}",
       "deck.yaml:11:36: audio.max_frequency: must be at least 80 and at most 4000 Hz, found 4001"},
      {"audio: {rate: fast, max_frequency: 4e4}",
       "deck.yaml:11:15: audio.rate: expected a number (samples per second), found 'fast'"},
      {"audio: {dc_block: 1}", "deck.yaml:11:19: audio.dc_block: must be at least 0 and below 1, found 1"},
      {"audio: {dc_block: 0.1, dc_corner: 10}",
       "deck.yaml:11:24: audio.dc_corner: dc_block says the same already; give one of the two"},
      {"audio: {dc_corner: 11025}",
       "deck.yaml:11:20: audio.dc_corner: must be at least 0 and below 11025 Hz, found 11025"},
      {"audio: {kernel_wavelengths: 0}",
       "deck.yaml:11:29: audio.kernel_wavelengths: must be at least 1 and at most 32, found 0"},
      {"radiation: {visibility: on}", "deck.yaml:11:25: radiation.visibility: must be one of off, found 'on'"},
      {"radiation: {visibility: {rate: 44101}}",
       "deck.yaml:11:32: radiation.visibility.rate: must be at least 0.01 and at most 44100 per second, found 44101"},
      {"radiation: {visibility: {rate: 0, often: 1}}",
       "deck.yaml:11:32: radiation.visibility.rate: must be at least 0.01 and at most 44100 per second, found 0\n"
       "deck.yaml:11:35: radiation.visibility.often: unknown key, known here: rate"},
      {"radiation: {model: huygen, air: {density: 0, speed: -3}}",
       "deck.yaml:11:20: radiation.model: must be one of huygens, rayleigh, kirchhoff, found 'huygen' (did you mean "
       "'huygens'?)\n"
       "deck.yaml:11:43: radiation.air.density: must be at least 1e-06 and at most 10000 kg/m3, found 0\n"
       "deck.yaml:11:53: radiation.air.speed: must be at least 50 and at most 100000 m/s, found -3"},
      {"radiation: {model: kirchhoff, surface_pressure: plane}",
       "deck.yaml:11:49: radiation.surface_pressure: must be one of plane_wave, pulsating, oscillating, found 'plane' "
       "(did you mean 'plane_wave'?)"},
      {"radiation: {model: rayleigh, surface_pressure: plane_wave}",
       "deck.yaml:11:30: radiation.surface_pressure: only model kirchhoff asks for it"},
      {"output: {frames_per_second: -1, wav: mp3, wav_full_scale: 0}",
       "deck.yaml:11:29: output.frames_per_second: must be at least 0 and at most 44100 per second, found -1\n"
       "deck.yaml:11:38: output.wav: must be one of float32, pcm24, pcm16, found 'mp3'\n"
       "deck.yaml:11:59: output.wav_full_scale: must be above 0 and at most 1e+12 Pa, found 0"},
      {"output: {checkpoint: {every_minutes: -1, keep: 0, kep: 1}}",
       "deck.yaml:11:38: output.checkpoint.every_minutes: must be at least 0 and at most 1000000 min, found -1\n"
       "deck.yaml:11:48: output.checkpoint.keep: must be at least 1 and at most 1000000, found 0\n"
       "deck.yaml:11:51: output.checkpoint.kep: unknown key (did you mean 'keep'?), known here: every_minutes, keep"},
      {"references: {a: 3, b: [], c: [440, -1]}",
       "deck.yaml:11:17: references.a: expected a list of frequencies (Hz), found '3'\n"
       "deck.yaml:11:23: references.b: expected a list of frequencies (Hz), found a list of 0\n"
       "deck.yaml:11:36: references.c.1: must be above 0 and at most 1e+09 Hz, found -1"},
      {"references: [440]",
       "deck.yaml:11:13: references: expected a map {NAME: [frequencies in Hz]}, found a list of 1"},
      {"gravity: 9.81", "deck.yaml:11:10: gravity: expected a list of 3 numbers (m/s2), e.g. [0, 0, 1], found '9.81'"},
  });
}

TEST_F(Mistaken, Documents) {
  EXPECT_EQ(mistakes(""), "deck.yaml:1:1: the deck is empty; docs/deck.md has an example");
  EXPECT_EQ(mistakes("# nothing\n"), "deck.yaml:1:1: the deck is empty; docs/deck.md has an example");
  EXPECT_EQ(mistakes("~"), "deck.yaml:1:1: the deck is empty; docs/deck.md has an example");
  EXPECT_EQ(mistakes("just text"), "deck.yaml:1:1: expected a map of keys, found 'just text'");
  EXPECT_EQ(mistakes("- a\n- b\n"), "deck.yaml:1:1: expected a map of keys, found a list of 2");
  const std::string outside = "not YAML, or a second document; a deck is a single one and ends before";
  EXPECT_EQ(mistakes(plate + "---\nb: 2\n"), "deck.yaml:11:1: " + outside);
  EXPECT_EQ(mistakes(",a: b\n"), "deck.yaml:1:1: " + outside);
  EXPECT_EQ(mistakes("a: 1\n b: 2\n"), "deck.yaml:2:3: not YAML: illegal map value");
  EXPECT_EQ(mistakes("a: [1, 2\n"), "deck.yaml:2:1: not YAML: end of sequence flow not found");
  EXPECT_EQ(mistakes("a: *b\n"), "deck.yaml:1:4: not YAML: the referenced anchor is not defined");
  EXPECT_EQ(mistakes("a: \"b\n"), "deck.yaml:2:1: not YAML: the text ends inside quotes; close them");
  EXPECT_EQ(mistakes(std::string("a: b\nc: \x04 d\n")),
            "deck.yaml:2:4: a control character (code 4); a deck is plain UTF-8 text");
}

TEST_F(Mistaken, NestingEnds) {
  EXPECT_EQ(mistakes("a: &a {b: *a}\n"),
            "deck.yaml:1:4: more than 10000 values or 20 levels of them; does an alias contain itself?");
  EXPECT_EQ(mistakes(std::string(100000, '[')), "deck.yaml:1:100001: not YAML: nested too deeply");
  std::string laughs = "a0: &a0 [x, x, x, x, x, x, x, x, x]\n";
  for (int i = 1; i < 9; ++i) {
    laughs += fmt::format("a{0}: &a{0} [*a{1}, *a{1}, *a{1}, *a{1}, *a{1}]\n", i, i - 1);
  }
  EXPECT_THAT(mistakes(laughs), testing::HasSubstr("more than 10000 values"));
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

TEST_F(Mistaken, SeveralBodiesNeedNaming) {
  const std::string deck = replaced(plate, "bodies:\n", "bodies:\n  bar: {mesh: shapes/bar.msh, material: steel}\n");
  EXPECT_EQ(mistakes(deck), "deck.yaml:9:8: loads.tap: the key 'body' is missing");
}

TEST_F(Mistaken, UnreadableDecks) {
  const auto answer = [](const std::filesystem::path& deck) {
    try {
      static_cast<void>(read_deck(deck));
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
    return std::string("no mistakes");
  };
  EXPECT_EQ(answer(folder / "no.yaml"),
            "can't read the deck " + (folder / "no.yaml").string() + ": No such file or directory");
  EXPECT_EQ(answer(folder), "can't read the deck " + folder.string() + ": it is a folder; name the .yaml file in it");
}

}  // namespace idiophone::scene
