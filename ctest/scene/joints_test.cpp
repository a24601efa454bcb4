// The section joints of a deck.

#include "idiophone/scene/large_amplitudes.hpp"
#include "mistaken.hpp"

namespace idiophone::scene {

class Joints : public Mistaken {
 protected:
  static std::string glue(const std::string& keys) {
    return "joints: {glue: {between: [plate.top, plate.bottom], " + keys + "}}\n";
  }
  [[nodiscard]] Joint read_glue(const std::string& keys) const { return read(plate + glue(keys)).joints.at(0); }
};

TEST_F(Joints, HaveTheStiffnessThatIsGiven) {
  const Joint joint = read_glue("stiffness: {normal: 2e12, tangential: 1e12}, damping: 1e-6, reach: 0.001");
  EXPECT_EQ(joint.surfaces[0].group, "top");
  EXPECT_EQ(joint.surfaces[1].group, "bottom");
  EXPECT_EQ(joint.stiffness->normal, 2e12);
  EXPECT_EQ(joint.stiffness->tangential, 1e12);
  EXPECT_EQ(joint.damping, 1e-6);
  EXPECT_EQ(joint.reach, 0.001);
  EXPECT_FALSE(read_glue("stiffness: rigid").stiffness.has_value());
}

TEST_F(Joints, HaveTheStiffnessAndDampingOfAMaterial) {
  const std::string soft =
      replaced(plate, "materials:\n",
               "materials:\n  glue: {young: 1e9, poisson: 0.25, density: 1, damping: {stiffness: 1e-7}}\n");
  const Joint joint = read(soft + glue("material: glue, thickness: 0.001")).joints.at(0);
  EXPECT_DOUBLE_EQ(joint.stiffness->normal, 1.2e12);  // E (1 - nu)/((1 + nu)(1 - 2 nu))/thickness
  EXPECT_DOUBLE_EQ(joint.stiffness->tangential, 4e11);
  EXPECT_EQ(joint.damping, 1e-7);
}

TEST_F(Joints, AreGlueBoltsSpringsOrHinges) {
  EXPECT_EQ(read_glue("stiffness: rigid").type, JointType::glue);
  const Joint bolt = read_glue("type: bolt, at: [0.1, 0.2, 0], radius: 0.01, reach: 0.001");
  EXPECT_EQ(bolt.type, JointType::bolt);
  EXPECT_EQ(bolt.place->at, Vector3(0.1, 0.2, 0));
  EXPECT_EQ(bolt.place->radius, 0.01);
  EXPECT_EQ(bolt.reach, 0.001);
  EXPECT_FALSE(bolt.stiffness.has_value());
  EXPECT_TRUE(bolt.is_layer());
  const Joint stud = read_glue(
      "type: bolt, shank: 0.003, radius: 0.006, axis: [[0, 0, 0], [0, 0, 1]], material: steel, preload: 4000");
  EXPECT_FALSE(stud.is_layer());
  EXPECT_EQ(stud.shank->radius, 0.003);
  EXPECT_EQ(stud.shank->washer, 0.006);
  EXPECT_EQ(stud.shank->young, 2e11);
  EXPECT_EQ(stud.shank->poisson, 0.3);
  EXPECT_EQ(stud.shank->preload, 4000);
  EXPECT_EQ(stud.axis.end, Vector3(0, 0, 1));
  const Joint mount = read_glue("type: spring, stiffness: 500, damping: 1e-3");
  EXPECT_EQ(mount.type, JointType::spring);
  EXPECT_EQ(mount.stiffness->normal, 500);
  EXPECT_EQ(mount.stiffness->tangential, 500);
  EXPECT_EQ(mount.damping, 1e-3);
  EXPECT_FALSE(mount.place.has_value());
  const Joint coil = read_glue("type: spring, stiffness: {axial: 500, lateral: 0}, at: [0.1, 0, 0]");
  EXPECT_EQ(coil.stiffness->normal, 500);
  EXPECT_EQ(coil.stiffness->tangential, 0);
  EXPECT_EQ(coil.place->radius, 0);
  const Joint pin = read_glue("type: hinge, axis: [[0, 0, 0], [1, 0, 0]], turning: {stiffness: 2, damping: 1e-3}");
  EXPECT_EQ(pin.type, JointType::hinge);
  EXPECT_EQ(pin.axis.end, Vector3(1, 0, 0));
  EXPECT_FALSE(pin.stiffness.has_value());
  EXPECT_EQ(pin.turning->stiffness, 2);
  EXPECT_EQ(pin.turning->damping, 1e-3);
  EXPECT_EQ(read_glue("type: hinge, axis: [[0, 0, 0], [1, 0, 0]], stiffness: 1e6").stiffness->tangential, 1e6);
}

TEST_F(Joints, AnswerMistakesOfTheirTypes) {
  expect_after({
      {glue("type: nail"), "deck.yaml:11:59: joints.glue.type: must be one of glue, bolt, spring, hinge, found 'nail'"},
      {glue("type: bolt, at: [0, 0, 0]"), "deck.yaml:11:16: joints.glue: the key 'radius' is missing"},
      {glue("type: bolt, at: [0, 0, 0], radius: 1, preload: 100"),
       "deck.yaml:11:91: joints.glue.preload: needs a shank: without one, a bolt is a layer under its washer, which no "
       "pull makes stiffer"},
      {glue("type: bolt, shank: 0.003, radius: 0.006, material: steel"),
       "deck.yaml:11:16: joints.glue: the key 'axis' is missing"},
      {glue("type: bolt, shank: 0.003, radius: 0.002, axis: [[0, 0, 0], [0, 0, 1]], material: steel, at: [0, 0, 0]"),
       "deck.yaml:11:79: joints.glue.radius: is that of the washers, which must not be smaller than that of the shank\n"
       "deck.yaml:11:141: joints.glue.at: has no meaning with shank: the shank goes from one end of its axis to the "
       "other one"},
      {glue("type: bolt, shank: 0.001, radius: 0.002, axis: [[0, 0, 0], [0, 0, 1]], material: steel, preload: 1e5"),
       "deck.yaml:11:141: joints.glue.preload: must be at most 1.257e+04 N, which stretches the shank by 2 %: give "
       "a "
       "smaller pull or a thicker shank"},
      {glue("type: spring, stiffness: rigid"),
       "deck.yaml:11:78: joints.glue.stiffness: expected a number (N/m), found 'rigid'"},
      {glue("type: spring, stiffness: {axial: 0, lateral: 0}"),
       "deck.yaml:11:78: joints.glue.stiffness: axial and lateral are both zero: a spring needs a stiffness (N/m)"},
      {glue("type: spring, stiffness: 1, radius: 1"),
       "deck.yaml:11:81: joints.glue.radius: has no meaning without at: a spring without a place holds the whole "
       "surfaces"},
      {glue("type: hinge"), "deck.yaml:11:16: joints.glue: the key 'axis' is missing"},
      {glue("type: hinge, axis: [0, 0, 1]"),
       "deck.yaml:11:72: joints.glue.axis: expected a list of 2 points, [[x, y, z], [x, y, z]], found a list of 3"},
      {glue("type: hinge, axis: [[0, 0, 1], [0, 0, 1]]"),
       "deck.yaml:11:72: joints.glue.axis: its two points are the same, so there is no line between them"},
      {glue("type: hinge, axis: [[0, 0, 0], [0, 0, 1]], turning: {damping: 1}"),
       "deck.yaml:11:105: joints.glue.turning: the key 'stiffness' is missing"},
  });
}

TEST_F(Joints, AnswerMistakes) {
  expect_after({
      {"joints: {glue: {stiffness: rigid}}\n", "deck.yaml:11:16: joints.glue: the key 'between' is missing"},
      {"joints: {glue: {between: plate.top, stiffness: rigid}}\n",
       "deck.yaml:11:26: joints.glue.between: expected a list of 2 surfaces, [BODY.GROUP, BODY.GROUP], found "
       "'plate.top'"},
      {"joints: {glue: {between: [plate, plte.top], stiffness: rigid}}\n",
       "deck.yaml:11:27: joints.glue.between.0: expected BODY.GROUP, a body and a physical group of its mesh, found "
       "'plate'\n"
       "deck.yaml:11:34: joints.glue.between.1: must be one of plate, found 'plte' (did you mean 'plate'?)"},
      {"joints: {glue: {between: [plate.top, plate.top], stiffness: rigid}}\n",
       "deck.yaml:11:26: joints.glue.between: names 'plate.top' twice; a joint is between two surfaces"},
      {glue("damping: 0"),
       "deck.yaml:11:16: joints.glue: needs stiffness: {normal, tangential}, stiffness: rigid, or material and "
       "thickness"},
      {glue("stiffness: stiff"),
       "deck.yaml:11:64: joints.glue.stiffness: expected rigid or {normal, tangential}, found 'stiff'"},
      {glue("stiffness: {normal: 0, tangential: 1}"),
       "deck.yaml:11:73: joints.glue.stiffness.normal: must be above 0 and at most 1e+18 Pa/m, found 0"},
      {glue("stiffness: rigid, material: steel"),
       "deck.yaml:11:53: joints.glue.stiffness: cannot stand beside material and thickness: give one of them"},
      {glue("stiffness: rigid, material: steel, thickness: 0.001"),
       "deck.yaml:11:53: joints.glue.stiffness: cannot stand beside material and thickness: give one of them"},
      {glue("material: steel"), "deck.yaml:11:16: joints.glue: the key 'thickness' is missing"},
      {glue("material: spruce, thickness: 0.001"),
       "deck.yaml:11:63: joints.glue.material: 'spruce' is not isotropic, as that of a joint must be: name another "
       "material"},
  });
}

TEST_F(Joints, AreRefusedBesideWhatTheyDoNotKnow) {
  const std::string joint = glue("stiffness: rigid");
  const std::string gong = replaced(plate, "fixed: [rim]", "model: {type: modal, large_amplitudes: true}");
  EXPECT_EQ(mistakes(gong + joint), "no mistakes");
  EXPECT_EQ(mistakes(gong + glue("type: hinge, axis: [[0, 0, 0], [0, 0, 1]]")),
            "deck.yaml:11:10: joints.glue: large_amplitudes work with glue, springs and bolts without a shank only, "
            "not with a "
            "hinge: leave out large_amplitudes, or use model: {type: finite_elements}");
  const std::string beside =
      replaced(replaced(gong, "bodies:\n", "bodies:\n  mass: {mesh: plate.geo, material: steel}\n"), "tap: {",
               "tap: {body: plate, ");
  EXPECT_EQ(
      mistakes(beside + "joints: {glue: {between: [plate.top, mass.bottom], stiffness: rigid}}\n"),
      "deck.yaml:12:38: joints.glue: body 'mass' has no large_amplitudes, but a body that joints tie to it has: give "
      "model: {type: modal, large_amplitudes: true} to all of them, or large_amplitudes to none");
}

TEST_F(Joints, CountTheSmallestStretchingTolerance) {
  std::vector<Body> bodies(3);
  for (const auto& [body, tolerance] : {std::pair(0, 0.01), {1, 0.001}, {2, 0.1}}) {
    bodies[body].modal = {.up_to = {}, .count = 4, .stretching_tolerance = tolerance, .where = {}};
  }
  EXPECT_EQ(stretching_tolerance(bodies), 0.001);
}

TEST_F(Joints, NeedBodiesThatCouldBeRead) {
  const std::string no_bodies = replaced(plate, "bodies:\n", "bodies:\nbodies:\n");
  EXPECT_NE(mistakes(no_bodies + glue("stiffness: rigid")), "no mistakes");
}

}  // namespace idiophone::scene
