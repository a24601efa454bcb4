// Mistakes in what moves and touches: bodies, constraints, obstacles, contacts, loads.

#include "mistaken.hpp"

namespace idiophone::scene {

using MistakenBodies = Mistaken;

TEST_F(MistakenBodies, Files) {
  write("bell.h5", "");
  expect({
      {"plate.geo", "plaet.geo", "deck.yaml:6:17: bodies.plate.mesh: no such file: DIR/plaet.geo"},
      {"plate.geo", "shapes", "deck.yaml:6:17: bodies.plate.mesh: expected a file, found the folder DIR/shapes"},
      {"plate.geo", "../nowhere/x.msh",
       "deck.yaml:6:17: bodies.plate.mesh: no such file: " + (folder.parent_path() / "nowhere/x.msh").string()},
      {"plate.geo", "deck.yaml",
       "deck.yaml:6:17: bodies.plate.mesh: must end in .geo, .msh, .h5, .step, .stp, .brep, .stl, .obj, .gltf, .glb, "
       ".ply, "
       ".fbx, found 'deck.yaml'"},
      {"plate.geo", "bell.h5, parameters: {scale: 1}",
       "deck.yaml:6:26: bodies.plate.parameters: a .h5 file is a mesh already and has no parameters; leave them out"},
      {"plate.geo", "plate.geo, parameters: {side: one}",
       "deck.yaml:6:47: bodies.plate.parameters.side: expected a number, found 'one'"},
      {"plate.geo", "plate.geo, parameters: [1]",
       "deck.yaml:6:40: bodies.plate.parameters: expected a map of numbers, found a list of 1"},
  });
}

TEST_F(MistakenBodies, Constraints) {
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
      {"fixed: [rim]", "groups: {lid: {}}",
       "deck.yaml:6:59: bodies.plate.groups.lid: needs one of the keys faces, normal and box"},
      {"fixed: [rim]", "groups: {lid: {faces: [1], normal: [0, 0, 1]}}",
       "deck.yaml:6:59: bodies.plate.groups.lid: needs one of the keys faces, normal and box"},
      {"fixed: [rim]", "groups: {lid: {faces: []}}",
       "deck.yaml:6:59: bodies.plate.groups.lid: expected the numbers of faces, or two corners of a box"},
      {"fixed: [rim]", "groups: {lid: {box: [[0, 0, 0]]}}",
       "deck.yaml:6:59: bodies.plate.groups.lid: expected the numbers of faces, or two corners of a box"},
      {"fixed: [rim]", "supports: {cord: {at: [0, 0, 0]}}",
       "deck.yaml:6:62: bodies.plate.supports.cord: a support needs a stiffness (N/m) or a damping (N s/m) above 0"},
      {"fixed: [rim]", "supports: {cord: {stiffness: -1}}",
       "deck.yaml:6:62: bodies.plate.supports.cord: the key 'at' is missing\n"
       "deck.yaml:6:74: bodies.plate.supports.cord.stiffness: must be at least 0 and at most 1e+15 N/m, found -1"},
  });
}

TEST_F(MistakenBodies, Gauges) {
  const std::string begin = "gauges: {bow: {type: ", one = "{at: [0, 0, 0]}";
  expect_after({
      {begin + "strian, points: [" + one + ", {at: [1, 0, 0]}]}}\n",
       "deck.yaml:11:22: gauges.bow.type: must be one of distance, strain, angle, curvature, found 'strian' (did you "
       "mean 'strain'?)"},
      {begin + "angle, points: [" + one + ", {at: [1, 0, 0]}]}}\n",
       "deck.yaml:11:37: gauges.bow.points: this type has 3 points, found 2"},
      {begin + "distance, points: [" + one + ", " + one + "]}}\n",
       "deck.yaml:11:40: gauges.bow.points: two of the points are the same"},
      {begin + "distance, points: [{at: [0, 0]}, " + one + "]}}\n",
       "deck.yaml:11:46: gauges.bow.points.0.at: expected a list of 3 numbers (m), e.g. [0, 0, 1], found a list of 2"},
  });
}

TEST_F(MistakenBodies, Fracture) {
  const auto with = [](const std::string& more) { return "fracture: [{surface: crack, strength: 4e7}]" + more; };
  expect({
      {"fixed: [rim]", "fracture: {surface: crack, strength: 4e7}",
       "deck.yaml:6:55: bodies.plate.fracture: expected a list, found a map"},
      {"fixed: [rim]", "fracture: [{surface: crack}]",
       "deck.yaml:6:56: bodies.plate.fracture.0: the key 'strength' is missing"},
      {"fixed: [rim]", "fracture: [{surface: crack, strength: 0}]",
       "deck.yaml:6:83: bodies.plate.fracture.0.strength: must be above 0 and at most 1e+15 Pa, found 0"},
      {"fixed: [rim]", "fracture: [{surface: crack, strength: 1}, {surface: crack, strength: 2}]",
       "deck.yaml:6:87: bodies.plate.fracture: the surface 'crack' is named twice"},
      {"fixed: [rim]", with(", element: hex, mass_scaling: {shift: 5}"),
       "deck.yaml:6:45: bodies.plate.fracture: has no meaning with mass_scaling, which ties nodes to each other: leave "
       "one of them out"},
      {"fixed: [rim]", with(", model: {type: modal}"),
       "deck.yaml:6:45: bodies.plate.fracture: has no meaning with a modal body, whose modes are those of the whole "
       "body: use model: {type: finite_elements}"},
      {"fixed: [rim]}\nloads:\n",
       with("}\nradiation: {model: waves, cell: 0.01}\nloads:\n  pull: {type: pluck, at: [0, 0, 0], force: [0, 0, "
            "1]}\n"),
       "deck.yaml:6:56: bodies.plate.fracture: the radiation model `waves` does not know surfaces that appear during a "
       "run: take `kirchhoff`, `rayleigh` or `huygens`\n"
       "deck.yaml:9:9: loads.pull: a pluck cannot act on body 'plate', which has `fracture`: take a pulse, or leave "
       "fracture out"},
  });
}

TEST_F(MistakenBodies, Rotations) {
  const auto driven = [](const std::string& more) { return "driven: [{group: rim, duration: 1, " + more + "}]"; };
  const std::string about_z = "rotation: {axis: [0, 0, 1], degrees: 5, pivot: [0, 0, 0]}";
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
      {"fixed: [rim]", driven("axes: xy, " + about_z),
       "deck.yaml:6:86: bodies.plate.driven.0.axes: must be xyz, or left out: a group that turns is held in all "
       "directions"},
      {"fixed: [rim]", driven("rotation: 5"),
       "deck.yaml:6:90: bodies.plate.driven.0.rotation: expected a map of keys, found '5'"},
  });
}

TEST_F(MistakenBodies, Obstacles) {
  write("bell.h5", "");
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
       "deck.yaml:12:57: obstacles.rock.mesh: must end in .geo, .msh, .h5, .step, .stp, .brep, .stl, .obj, .gltf, "
       ".glb, "
       ".ply, .fbx, found "
       "'deck.yaml'"},
      {obstacle("rock", "shape: surface, at: [0, 0, 0], mesh: bell.h5, parameters: {a: 1}"),
       "deck.yaml:12:66: obstacles.rock.parameters: a .h5 file is a mesh already and has no parameters; leave them "
       "out"},
      {"obstacles: {plate: {shape: sphere, at: [0, 0, 0], radius: 1}}",
       "deck.yaml:11:13: obstacles.plate: a body is called 'plate' already; contacts could not tell the two apart, so "
       "choose another name\n"
       "deck.yaml:11:13: obstacles.plate: no contact names it, so bodies pass through it; add 'contacts: "
       "{NAME: {between: [BODY, plate]}}', or leave it out"},
      {"obstacles: [floor]", "deck.yaml:11:12: obstacles: expected a map of names, found a list of 1"},
  });
}

TEST_F(MistakenBodies, Contacts) {
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
      {between("[floor, wall]"), "deck.yaml:12:57: contacts.c.between: names no body; one of the two must be a body"},
      {between("[plate, wall]"),
       "deck.yaml:11:13: obstacles.floor: no contact names it, so bodies pass through it; add 'contacts: "
       "{NAME: {between: [BODY, floor]}}', or leave it out\n"
       "deck.yaml:12:44: contacts.c: 'rest' at deck.yaml:12:12 is between the same two already; leave one out"},
      {contact(", friction: -1"), "deck.yaml:12:83: contacts.c.friction: must be at least 0 and at most 100, found -1"},
      {contact(", friction: {sticking: 0.3, sliding: 0.4}"),
       "deck.yaml:12:108: contacts.c.friction.sliding: must be at most sticking, which is 0.3, found 0.4"},
      {contact(", friction: {sliding: 0.4}"), "deck.yaml:12:83: contacts.c.friction: the key 'sticking' is missing"},
      {contact(", friction: {type: elastic}"),
       "deck.yaml:12:90: contacts.c.friction.type: must be one of coulomb, elasto_plastic, found 'elastic'"},
      {contact(", friction: {type: elasto_plastic, sliding: 0.9}"),
       "deck.yaml:12:83: contacts.c.friction: the coefficient of sliding, 0.9, is above that of sticking, 0.8"},
      {contact(", friction: {type: elasto_plastic, stribek_speed: 1}"),
       "deck.yaml:12:106: contacts.c.friction.stribek_speed: unknown key (did you mean 'stribeck_speed'?), known here: "
       "type, sticking, sliding, stribeck_speed, stiffness, damping, viscosity, break_away"},
      {contact(", friction: {sticking: 1, sliding: 1, break_away: 0.5}"),
       "deck.yaml:12:109: contacts.c.friction.break_away: unknown key, known here: type, sticking, sliding"},
      {contact(", damping: -1"),
       "deck.yaml:12:82: contacts.c.damping: must be at least 0 and at most 1000 s, found -1"},
      {contact(", stiffness: 0"),
       "deck.yaml:12:84: contacts.c.stiffness: must be above 0 and at most 1e+24 Pa/m, found 0"},
      {contact(", stifness: 1"),
       "deck.yaml:12:73: contacts.c.stifness: unknown key (did you mean 'stiffness'?), known here: between, friction, "
       "damping, stiffness"},
  });
}

TEST_F(MistakenBodies, TwoContactsOfTwoBodies) {
  const std::string deck =
      replaced(replaced(plate, "bodies:\n", "bodies:\n  bar: {mesh: shapes/bar.msh, material: steel}\n"), "tap: {",
               "tap: {body: bar, ") +
      "contacts:\n  a: {between: [plate, bar]}\n  b: {between: [bar, plate]}\n";
  EXPECT_EQ(mistakes(deck),
            "deck.yaml:14:3: contacts.b: 'a' at deck.yaml:13:3 is between the same two already; leave one out");
}

TEST_F(MistakenBodies, SeveralBodiesNeedNaming) {
  const std::string deck = replaced(plate, "bodies:\n", "bodies:\n  bar: {mesh: shapes/bar.msh, material: steel}\n");
  EXPECT_EQ(mistakes(deck), "deck.yaml:9:8: loads.tap: the key 'body' is missing");
}

TEST_F(MistakenBodies, Winds) {
  expect({
      {"loads:\n", "loads:\n  breeze: {type: wind, velocity: [0, 0, 0]}\n",
       "deck.yaml:8:34: loads.breeze.velocity: is zero; a wind needs a velocity (m/s)"},
      {"loads:\n", "loads:\n  breeze: {type: wind, drag: 1}\n",
       "deck.yaml:8:11: loads.breeze: the key 'velocity' is missing"},
  });
}

TEST_F(MistakenBodies, Bows) {
  expect({
      {"loads:\n", "loads:\n  rub: {type: bow, at: [0, 0, 0], direction: [1, 0, 0], speed: [], load: -1}\n",
       "deck.yaml:8:64: loads.rub.speed: the list is empty; give a number, or points [time, value]\n"
       "deck.yaml:8:74: loads.rub.load: must be at least 0 and at most 1000000 N, found -1"},
      {"loads:\n",
       "loads:\n  rub: {type: bow, at: [0, 0, 0], direction: [1, 0, 0], speed: 1, load: 1, friction: {sliding: 0.9}}\n",
       "deck.yaml:8:86: loads.rub.friction: the coefficient of sliding, 0.9, is above that of sticking, 0.8"},
      {"loads:\n", "loads:\n  rub: {type: bow, at: [0, 0, 0], direction: [1, 0, 0], speed: 1, load: 0}\n",
       "deck.yaml:8:73: loads.rub.load: is zero; a bow needs a load that presses it on (N)"},
  });
}

TEST_F(MistakenBodies, Signals) {
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

}  // namespace idiophone::scene
