#include "deck_fixture.hpp"

namespace idiophone::scene {

using OverridesTest = DeckTest;

TEST_F(OverridesTest, ReplaceValues) {
  const Scene scene = read(plate, {"time.duration=0.5", "loads.tap.force=[1, 2, 3]", "name=other"});
  EXPECT_EQ(scene.time.duration, 0.5);
  EXPECT_EQ(scene.pulses.at(0).force, Vector3(1, 2, 3));
  EXPECT_EQ(scene.name, "other");
  EXPECT_EQ(scene.deck_text, plate);
  EXPECT_THAT(scene.overrides, testing::ElementsAre("time.duration=0.5", "loads.tap.force=[1, 2, 3]", "name=other"));
}

TEST_F(OverridesTest, AddKeysThatTheDeckDoesNotHave) {
  const Scene scene =
      read(plate, {"output.checkpoint.keep=7", "bodies.plate.parameters.side=0.25",
                   "materials.brass={young: 1e11, poisson: 0.35, density: 8500}", "bodies.plate.material=brass"});
  EXPECT_EQ(scene.output.checkpoint_keep, 7);
  EXPECT_EQ(scene.bodies.at(0).parameters.at("side"), 0.25);
  EXPECT_EQ(scene.materials.at(scene.bodies.at(0).material).name, "brass");
}

TEST_F(OverridesTest, ReachElementsOfLists) {
  const Scene scene = read(plate, {"bodies.plate.fixed.0=edge", "bodies.plate.fixed.1={group: foot, axes: z}",
                                   "listeners.ear.position.2=4"});
  ASSERT_EQ(scene.bodies.at(0).fixed.size(), 2U);
  EXPECT_EQ(scene.bodies[0].fixed[0].group, "edge");
  EXPECT_EQ(scene.bodies[0].fixed[1].group, "foot");
  EXPECT_EQ(scene.listeners.at(0).receivers.at(0).position, Vector3(0, 0, 4));
  EXPECT_TRUE(read(plate, {"bodies.plate.fixed=[]"}).bodies.at(0).fixed.empty());
}

TEST_F(OverridesTest, RemoveKeysByNull) {
  EXPECT_TRUE(read(plate, {"bodies.plate.fixed=null"}).bodies.at(0).fixed.empty());
  const Scene scene = read(plate, {"loads.tap=null", "loads.tap={at: [0, 0, 0], force: [0, 0, 1], duration: 1}"});
  EXPECT_EQ(scene.pulses.at(0).force, Vector3(0, 0, 1));
}

TEST_F(OverridesTest, TheLastOfSeveralCounts) {
  EXPECT_EQ(read(plate, {"time.duration=2", "time={duration: 3, safety: 0.5}", "time.duration=4"}).time.duration, 4.0);
  EXPECT_EQ(read(plate, {"time={duration: 3, safety: 0.5}", "time.duration=4"}).time.safety, 0.5);
}

TEST_F(OverridesTest, MendAWrongDeck) {
  EXPECT_EQ(read(replaced(plate, "duration: 1.0}", "duration: x}"), {"time.duration=2"}).time.duration, 2.0);
  EXPECT_EQ(read(replaced(plate, "{duration: 1.0}", ""), {"time.duration=2"}).time.duration, 2.0);
}

TEST_F(OverridesTest, LeaveTheOtherUseOfAnAliasAlone) {
  const std::string deck =
      replaced(replaced(plate, "steel: {young", "steel: &metal {young"), "bodies:", "  gong: *metal\nbodies:");
  const Scene scene = read(deck, {"materials.steel.young=1e11"});
  EXPECT_EQ(scene.materials.at(0).young, 1e11);
  EXPECT_EQ(scene.materials.at(1).young, 2e11);
}

TEST_F(OverridesTest, AreCheckedLikeTheDeck) {
  const std::string form = "expected KEY.PATH=VALUE, e.g. --set time.duration=0.5";
  const std::vector<std::pair<std::string, std::string>> wrong = {
      {"time.duration=-1", "1:15: time.duration: must be above 0 and at most 86400 s, found -1"},
      {"time.duration=", "1:15: time.duration: expected a number (s), found nothing"},
      {"time.durration=1",
       "1:6: time.durration: unknown key (did you mean 'duration'?), known here: duration, "
       "steps_per_sample, safety, wall_clock_limit"},
      {"name.first=x", "1:6: name: is the single value 'plate' and has no 'first' inside"},
      {"bodies.plate.fixed.2=x",
       "1:20: bodies.plate.fixed: is a list; expected an index from 0 to 1 (one after the last "
       "appends), found '2'"},
      {"bodies.plate.fixed.rim=x",
       "1:20: bodies.plate.fixed: is a list; expected an index from 0 to 1 (one after the "
       "last appends), found 'rim'"},
      {"bodies.plate.fixed.-1=x",
       "1:20: bodies.plate.fixed: is a list; expected an index from 0 to 1 (one after the "
       "last appends), found '-1'"},
      {"bodies.plate.mesh=no.geo", "1:19: bodies.plate.mesh: no such file: DIR/no.geo"},
      {"bodies.plate={mesh: plate.geo, material: steel, element: tet5}",
       "1:58: bodies.plate.element: must be one of tet4, tet10, hex, found 'tet5' (did you mean 'tet4'?)"},
      {"gravity=[0, 0", "1:14: not YAML: end of sequence flow not found"},
      {"name='x", "1:8: not YAML: the text ends inside quotes; close them"},
      {"time={duration: 1, duration: 2}",
       "1:20: time.duration: is said twice, first at --set time={duration: 1, duration: 2}:1:7; leave one out"},
      {"bodies.plat.fixed=null", "1:1: bodies.plat: the deck has no such value to remove (did you mean 'plate'?)"},
      {"bodies.plate.fixed.0=null",
       "1:1: bodies.plate.fixed.0: an element of a list can't be removed; give the whole list"},
      {"time", "1:1: " + form},
      {"", "1:1: " + form},
      {"=5", "1:1: " + form},
      {"time.=5", "1:1: " + form},
      {".time=5", "1:1: " + form},
      {"time..duration=5", "1:1: " + form},
  };
  for (const auto& [argument, answer] : wrong) {
    EXPECT_EQ(mistakes(plate, {argument}), fmt::format("--set {}:{}", argument, answer));
  }
}

}  // namespace idiophone::scene
