#include <numbers>
#include <set>
#include <string>

#include "deck_fixture.hpp"

namespace idiophone::scene {

using ReadDeck = DeckTest;

constexpr double unending = std::numeric_limits<double>::infinity();

TEST_F(ReadDeck, FillsInTheDefaultsOfASmallDeck) {
  const Scene scene = read(plate);
  EXPECT_EQ(scene.name, "plate");
  EXPECT_EQ(scene.deck, folder / "deck.yaml");
  EXPECT_EQ(scene.deck_text, plate);
  EXPECT_TRUE(scene.overrides.empty());
  EXPECT_EQ(scene.time.duration, 1.0);
  EXPECT_FALSE(scene.time.steps_per_sample);
  EXPECT_EQ(scene.time.safety, 0.9);
  EXPECT_FALSE(scene.time.wall_clock_limit);
  EXPECT_EQ(scene.materials.at(0).damping.mass, 0.0);
  EXPECT_EQ(scene.materials.at(0).damping.stiffness, 0.0);
  const Body& body = scene.bodies.at(0);
  EXPECT_EQ(body.mesh, folder / "plate.geo");
  EXPECT_EQ(body.element, element::tet10);
  EXPECT_EQ(body.velocity, Vector3(0, 0, 0));
  EXPECT_EQ(body.spin, Vector3(0, 0, 0));
  EXPECT_EQ(body.fixed.at(0).axes, (Axes{true, true, true}));
  const ForcePulse& tap = scene.pulses.at(0);
  EXPECT_EQ(tap.body, 0U);
  EXPECT_EQ(tap.place.radius, 0.0);
  EXPECT_EQ(tap.signal.shape, Signal::Shape::half_sine);
  EXPECT_EQ(tap.signal.start, 0.0);
  EXPECT_EQ(scene.gravity, Vector3(0, 0, 0));
  EXPECT_EQ(scene.audio.rate, 44100);
  EXPECT_EQ(scene.audio.max_frequency, 22050.0);
  EXPECT_EQ(scene.audio.kernel_wavelengths, 3.0);
  EXPECT_EQ(scene.radiation.model, RadiationModel::kirchhoff);
  EXPECT_NEAR(scene.radiation.air.impedance(), 415.0, 0.1);
  EXPECT_EQ(scene.radiation.visibility->interval(44100), 441);
  EXPECT_EQ(scene.output.frames_per_second, 60.0);
  EXPECT_EQ(scene.output.motion_per_second, 2000.0);
  EXPECT_EQ(scene.output.wav, WavFormat::float32);
  EXPECT_FALSE(scene.output.wav_full_scale);
  EXPECT_EQ(scene.output.checkpoint_minutes, 15.0);
  EXPECT_EQ(scene.output.checkpoint_keep, 3);
}

TEST_F(ReadDeck, ReadsTimeAndMaterials) {
  const Scene scene = read(replaced(
      replaced(plate, "{duration: 1.0}", "{duration: 2, steps_per_sample: 4.8e1, safety: 1, wall_clock_limit: 3600}"),
      "density: 7850", "density: 7850, damping: {mass: 2.5, stiffness: +1.0e-8}"));
  EXPECT_EQ(scene.time.duration, 2.0);
  EXPECT_EQ(scene.time.steps_per_sample, 48);
  EXPECT_EQ(scene.time.safety, 1.0);
  EXPECT_EQ(scene.time.wall_clock_limit, 3600.0);
  const Material& steel = scene.materials.at(0);
  EXPECT_EQ(steel.name, "steel");
  EXPECT_EQ(steel.young, 2e11);
  EXPECT_EQ(steel.poisson, 0.3);
  EXPECT_EQ(steel.density, 7850.0);
  EXPECT_EQ(steel.damping.mass, 2.5);
  EXPECT_EQ(steel.damping.stiffness, 1e-8);
  EXPECT_EQ(to_string(steel.where), (folder / "deck.yaml").string() + ":4:3");
}

TEST_F(ReadDeck, ReadsBodies) {
  const Scene scene = read(
      "name: bodies\n"
      "time: {duration: 1}\n"
      "materials:\n"
      "  steel: &steel {young: 2.0e11, poisson: 0.3, density: 7850}\n"
      "  other: *steel\n"
      "bodies:\n"
      "  bar:\n"
      "    mesh: shapes/bar.msh\n"
      "    element: tet4\n"
      "    material: other\n"
      "    fixed: [left, {group: right, axes: zx}]\n"
      "    driven:\n"
      "      - {group: middle, displacement: [0, 1e-3, 0], axes: y, shape: sine, start: 0.5, frequency: 3}\n"
      "    supports:\n"
      "      cord: {at: [1, 2, 3], radius: 0.01, stiffness: 1000, damping: 5}\n"
      "    velocity: [1, 0, -1]\n"
      "    spin: [0, 6, 0]\n"
      "  plate: {mesh: plate.geo, parameters: {side: 0.3, size: 1e-2}, material: steel}\n"
      "gravity: [0, 0, -9.81]\n"
      "listeners:\n"
      "  ear: {type: mono, position: [0, 0, 1]}\n");
  ASSERT_EQ(scene.bodies.size(), 2U);
  const Body& bar = scene.bodies[0];
  EXPECT_EQ(bar.name, "bar");
  EXPECT_EQ(bar.mesh, folder / "shapes/bar.msh");
  EXPECT_EQ(bar.mesh_where.line, 8);
  EXPECT_EQ(bar.mesh_where.column, 11);
  EXPECT_EQ(bar.where.line, 7);
  EXPECT_EQ(bar.element, element::tet4);
  EXPECT_EQ(scene.materials.at(bar.material).name, "other");
  ASSERT_EQ(bar.fixed.size(), 2U);
  EXPECT_EQ(bar.fixed[0].group, "left");
  EXPECT_EQ(bar.fixed[0].where.column, 13);
  EXPECT_EQ(bar.fixed[1].group, "right");
  EXPECT_EQ(bar.fixed[1].axes, (Axes{true, false, true}));
  ASSERT_EQ(bar.driven.size(), 1U);
  EXPECT_EQ(bar.driven[0].group, "middle");
  EXPECT_EQ(bar.driven[0].displacement, Vector3(0, 1e-3, 0));
  EXPECT_EQ(bar.driven[0].axes, (Axes{false, true, false}));
  EXPECT_EQ(bar.driven[0].signal.shape, Signal::Shape::sine);
  EXPECT_EQ(bar.driven[0].signal.start, 0.5);
  EXPECT_EQ(bar.driven[0].signal.frequency, 3.0);
  EXPECT_EQ(bar.driven[0].signal.duration, unending);
  ASSERT_EQ(bar.supports.size(), 1U);
  EXPECT_EQ(bar.supports[0].name, "cord");
  EXPECT_EQ(bar.supports[0].place.at, Vector3(1, 2, 3));
  EXPECT_EQ(bar.supports[0].place.radius, 0.01);
  EXPECT_EQ(bar.supports[0].place.where.line, 15);
  EXPECT_EQ(bar.supports[0].stiffness, 1000.0);
  EXPECT_EQ(bar.supports[0].damping, 5.0);
  EXPECT_EQ(bar.velocity, Vector3(1, 0, -1));
  EXPECT_EQ(bar.spin, Vector3(0, 6, 0));
  EXPECT_THAT(scene.bodies[1].parameters, testing::ElementsAre(std::pair("side", 0.3), std::pair("size", 1e-2)));
  EXPECT_EQ(scene.bodies[1].parameters_where.at("size").column, 52);
  EXPECT_EQ(scene.gravity, Vector3(0, 0, -9.81));
}

TEST_F(ReadDeck, PutsFacesInThePlaceOfTheirNames) {
  const Scene scene = read(
      replaced(plate, "fixed: [rim]",
               "groups: {lid: {normal: [0, 0, 2]}, rim: {faces: [3, 12]}, feet: {box: [[0, -1, 0], [1, 1, 0.25]]}},"
               " fixed: [rim, {group: feet, axes: z}, edge], driven: [{group: lid, displacement: [0, 0, 1],"
               " duration: 1}]"));
  const Body& body = scene.bodies.at(0);
  ASSERT_EQ(body.fixed.size(), 3U);
  EXPECT_EQ(body.fixed[0].group, "faces 3 12");
  EXPECT_EQ(body.fixed[1].group, "box 0 -1 0 1 1 0.25");
  EXPECT_EQ(body.fixed[2].group, "edge");
  ASSERT_EQ(body.driven.size(), 1U);
  EXPECT_EQ(body.driven[0].group, "normal 0 0 1");
}

TEST_F(ReadDeck, ReadsHingesAndRotations) {
  const Scene scene =
      read(replaced(plate, "fixed: [rim]",
                    "fixed: [rim], hinges: [axle], driven: [{group: top, duration: 1, displacement: [0, "
                    "0, 1], rotation: {axis: [0, -2, 0], degrees: 90, pivot: [1, 2, 3]}}]"));
  const Body& body = scene.bodies.at(0);
  ASSERT_EQ(body.fixed.size(), 2U);
  EXPECT_FALSE(body.fixed[0].hinge);
  EXPECT_EQ(body.fixed[1].group, "axle");
  EXPECT_TRUE(body.fixed[1].hinge);
  EXPECT_EQ(body.fixed[1].axes, (Axes{true, true, true}));
  EXPECT_EQ(body.fixed[1].where.column, 68);
  const DrivenGroup& driven = body.driven.at(0);
  EXPECT_EQ(driven.displacement, Vector3(0, 0, 1));
  EXPECT_LT((driven.rotation - Vector3(0, -std::numbers::pi / 2, 0)).norm(), 1e-15);
  EXPECT_EQ(driven.pivot, Vector3(1, 2, 3));
}

TEST_F(ReadDeck, ReadsObstacles) {
  const Scene scene = read(plate +
                           "obstacles:\n"
                           "  floor: {shape: half_space, at: [0, 0, 1], direction: [0, 3, 0]}\n"
                           "  block: {shape: box, at: [1, 0, 0], size: [1, 2, 3], rotation: {axis: [5, 0, 0], "
                           "degrees: -180}}\n"
                           "  ball: {shape: sphere, at: [0, 2, 0], radius: 0.1}\n"
                           "  post: {shape: cylinder, at: [0, 0, 0], radius: 0.2, length: 1.5}\n"
                           "  rock: {shape: surface, at: [0, 0, 4], mesh: plate.geo, parameters: {side: 2}}\n"
                           "contacts:\n"
                           "  a: {between: [floor, plate], friction: 0.3}\n"
                           "  b: {between: [plate, block], friction: {sticking: 0.4, sliding: 0.2}}\n"
                           "  c: {between: [plate, ball], damping: 1e-6}\n"
                           "  d: {between: [plate, post], stiffness: 1e12}\n"
                           "  e: {between: [plate, rock]}\n");
  using Shape = Obstacle::Shape;
  ASSERT_EQ(scene.obstacles.size(), 5U);
  const Obstacle& floor = scene.obstacles[0];
  EXPECT_EQ(floor.name, "floor");
  EXPECT_EQ(floor.shape, Shape::half_space);
  EXPECT_EQ(floor.at, Vector3(0, 0, 1));
  EXPECT_EQ(floor.direction, Vector3(0, 1, 0));
  EXPECT_EQ(floor.where.line, 12);
  const Obstacle& block = scene.obstacles[1];
  EXPECT_EQ(block.shape, Shape::box);
  EXPECT_EQ(block.size, Vector3(1, 2, 3));
  EXPECT_EQ(block.rotation, Vector3(-std::numbers::pi, 0, 0));
  EXPECT_EQ(scene.obstacles[2].shape, Shape::sphere);
  EXPECT_EQ(scene.obstacles[2].radius, 0.1);
  const Obstacle& post = scene.obstacles[3];
  EXPECT_EQ(post.shape, Shape::cylinder);
  EXPECT_EQ(post.direction, Vector3(0, 0, 1));
  EXPECT_EQ(post.radius, 0.2);
  EXPECT_EQ(post.length, 1.5);
  const Obstacle& rock = scene.obstacles[4];
  EXPECT_EQ(rock.shape, Shape::surface);
  EXPECT_EQ(rock.mesh, folder / "plate.geo");
  EXPECT_EQ(rock.mesh_where.line, 16);
  EXPECT_EQ(rock.parameters.at("side"), 2.0);
  EXPECT_EQ(rock.parameters_where.at("side").line, 16);
}

TEST_F(ReadDeck, ReadsContacts) {
  const Scene scene =
      read(replaced(replaced(plate, "bodies:\n", "bodies:\n  bar: {mesh: shapes/bar.msh, material: steel}\n"), "tap: {",
                    "tap: {body: bar, ") +
           "obstacles:\n"
           "  wall: {shape: sphere, at: [0, 0, 0], radius: 1}\n"
           "  floor: {shape: half_space, at: [0, 0, 0]}\n"
           "contacts:\n"
           "  bounce: {between: [floor, plate], friction: 0.3, damping: 1e-6}\n"
           "  lean: {between: [bar, wall], friction: {sticking: 0.4, sliding: 0.2}, stiffness: 1e12}\n"
           "  clash: {between: [plate, bar]}\n"
           "  fold: {between: [bar, bar]}\n"
           "  rub: {between: [bar, floor], friction: {type: elasto_plastic, sliding: 0.2, stiffness: 3e4}}\n");
  ASSERT_EQ(scene.contacts.size(), 5U);
  const Contact& bounce = scene.contacts[0];
  EXPECT_EQ(bounce.name, "bounce");
  EXPECT_EQ(scene.bodies.at(bounce.body).name, "plate");
  EXPECT_FALSE(bounce.other);
  EXPECT_EQ(scene.obstacles.at(bounce.obstacle.value()).name, "floor");
  EXPECT_EQ(bounce.friction.sticking, 0.3);
  EXPECT_EQ(bounce.friction.sliding, 0.3);
  EXPECT_EQ(bounce.damping, 1e-6);
  EXPECT_FALSE(bounce.stiffness);
  EXPECT_EQ(bounce.where.line, 16);
  const Contact& lean = scene.contacts[1];
  EXPECT_EQ(scene.bodies.at(lean.body).name, "bar");
  EXPECT_EQ(scene.obstacles.at(lean.obstacle.value()).name, "wall");
  EXPECT_EQ(lean.friction.sticking, 0.4);
  EXPECT_EQ(lean.friction.sliding, 0.2);
  EXPECT_FALSE(lean.friction.memory);
  EXPECT_EQ(lean.stiffness, 1e12);
  const Contact& clash = scene.contacts[2];
  EXPECT_EQ(scene.bodies.at(clash.body).name, "plate");
  EXPECT_EQ(scene.bodies.at(clash.other.value()).name, "bar");
  EXPECT_FALSE(clash.obstacle);
  EXPECT_EQ(clash.friction.sticking, 0.0);
  EXPECT_EQ(clash.damping, 0.0);
  const Contact& fold = scene.contacts[3];
  EXPECT_EQ(scene.bodies.at(fold.body).name, "bar");
  EXPECT_EQ(fold.other, fold.body);
  const friction::Law& law = scene.contacts[4].friction.memory.value();
  EXPECT_EQ(law.sticking, friction::Law().sticking);
  EXPECT_EQ(law.sliding, 0.2);
  EXPECT_EQ(law.stiffness, 3e4);
}

TEST_F(ReadDeck, ReadsWinds) {
  const Scene scene = read(replaced(plate, "loads:\n",
                                    "loads:\n  breeze: {type: wind, velocity: [1, 2, 3]}\n"
                                    "  storm: {type: wind, body: plate, velocity: [30, 0, 0], drag: 2, start: 1, "
                                    "gusts: {intensity: 0.5, time: 0.1, seed: 7}}\n"));
  ASSERT_EQ(scene.winds.size(), 2U);
  EXPECT_EQ(scene.winds[0].name, "breeze");
  EXPECT_FALSE(scene.winds[0].body.has_value());
  EXPECT_EQ(scene.winds[0].velocity, Vector3(1, 2, 3));
  EXPECT_EQ(scene.winds[0].drag, 1.2);
  EXPECT_EQ(scene.winds[0].gusts.intensity, 0.0);
  EXPECT_EQ(scene.winds[0].signal.at(1e6), 1.0);
  EXPECT_EQ(scene.winds[1].body, 0U);
  EXPECT_EQ(scene.winds[1].drag, 2.0);
  EXPECT_EQ(scene.winds[1].gusts.intensity, 0.5);
  EXPECT_EQ(scene.winds[1].gusts.time, 0.1);
  EXPECT_EQ(scene.winds[1].gusts.seed, 7U);
  EXPECT_EQ(scene.winds[1].signal.at(0.5), 0.0);
}

TEST_F(ReadDeck, ReadsBows) {
  const Scene scene =
      read(replaced(plate, "loads:\n",
                    "loads:\n  rub: {type: bow, at: [1, 2, 3], direction: [0, 0, 2], speed: 0.2, load: 1}\n"
                    "  draw: {type: bow, at: [0, 0, 0], radius: 0.1, direction: [1, 0, 0], speed: [[0, "
                    "0], [1, 0.4]], load: 2, start: 0.5, duration: 3, friction: {sliding: 0.2}}\n"));
  ASSERT_EQ(scene.bows.size(), 2U);
  EXPECT_EQ(scene.bows[0].name, "rub");
  EXPECT_EQ(scene.bows[0].place.at, Vector3(1, 2, 3));
  EXPECT_EQ(scene.bows[0].direction, Vector3::UnitZ());
  EXPECT_EQ(scene.bows[0].speed.at(7.0), 0.2);
  EXPECT_EQ(scene.bows[0].load_at(7.0), 1.0);
  EXPECT_EQ(scene.bows[0].start, 0.0);
  EXPECT_EQ(scene.bows[0].duration, unending);
  EXPECT_EQ(scene.bows[0].friction.sliding, 0.3);
  EXPECT_EQ(scene.bows[1].place.radius, 0.1);
  EXPECT_EQ(scene.bows[1].speed.at(0.5), 0.2);
  EXPECT_EQ(scene.bows[1].load_at(0.005), 1.0);
  EXPECT_EQ(scene.bows[1].start, 0.5);
  EXPECT_EQ(scene.bows[1].duration, 3.0);
  EXPECT_EQ(scene.bows[1].friction.sliding, 0.2);
}

TEST_F(ReadDeck, ReadsGauges) {
  const Scene scene =
      read(replaced(replaced(plate, "bodies:\n", "bodies:\n  bar: {mesh: shapes/bar.msh, material: steel}\n"), "tap: {",
                    "tap: {body: bar, ") +
           "gauges:\n"
           "  gap: {type: distance, points: [{body: bar, at: [0, 0, 1]}, {body: plate, at: [0, 0, 0], radius: 0.1}]}\n"
           "  bow: {type: curvature, points: [{body: bar, at: [0, 0, 0]}, {body: bar, at: [1, 0, 0]}, {body: bar, at: "
           "[2, 0, 0]}]}\n");
  ASSERT_EQ(scene.gauges.size(), 2U);
  EXPECT_EQ(scene.gauges[0].name, "gap");
  EXPECT_EQ(scene.gauges[0].quantity, Gauge::Quantity::distance);
  ASSERT_EQ(scene.gauges[0].points.size(), 2U);
  EXPECT_EQ(scene.bodies.at(scene.gauges[0].points[0].body).name, "bar");
  EXPECT_EQ(scene.gauges[0].points[0].place.at, Vector3(0, 0, 1));
  EXPECT_EQ(scene.bodies.at(scene.gauges[0].points[1].body).name, "plate");
  EXPECT_EQ(scene.gauges[0].points[1].place.radius, 0.1);
  EXPECT_EQ(scene.gauges[1].quantity, Gauge::Quantity::curvature);
  EXPECT_EQ(scene.gauges[1].points.size(), 3U);
}

TEST_F(ReadDeck, ReadsLoads) {
  const Scene scene = read(
      replaced(replaced(plate, "bodies:\n", "bodies:\n  bar: {mesh: shapes/bar.msh, material: steel}\n"),
               "  tap: {at: [0, 0, 0], force: [0, 0, -20], duration: 1.0e-3}",
               "  tap: {body: plate, at: [1, 2, 3], radius: 0.5, force: [0, 0, -20], start: 0.25, duration: 1.0e-3}\n"
               "  push: {type: pulse, body: bar, at: [0, 0, 0], force: [1, 0, 0], shape: constant}\n"
               "  pull: {type: pluck, body: bar, at: [4, 5, 6], radius: 0.1, force: [0, 7, 0]}"));
  ASSERT_EQ(scene.pulses.size(), 2U);
  EXPECT_EQ(scene.pulses[0].name, "tap");
  EXPECT_EQ(scene.bodies.at(scene.pulses[0].body).name, "plate");
  EXPECT_EQ(scene.pulses[0].place.at, Vector3(1, 2, 3));
  EXPECT_EQ(scene.pulses[0].place.radius, 0.5);
  EXPECT_EQ(scene.pulses[0].place.where.line, 9);
  EXPECT_EQ(scene.pulses[0].place.where.column, 26);
  EXPECT_EQ(scene.pulses[0].force, Vector3(0, 0, -20));
  EXPECT_EQ(scene.pulses[0].signal.start, 0.25);
  EXPECT_EQ(scene.pulses[0].signal.duration, 1e-3);
  EXPECT_EQ(scene.pulses[1].signal.shape, Signal::Shape::constant);
  EXPECT_EQ(scene.pulses[1].signal.duration, unending);
  ASSERT_EQ(scene.plucks.size(), 1U);
  EXPECT_EQ(scene.plucks[0].name, "pull");
  EXPECT_EQ(scene.bodies.at(scene.plucks[0].body).name, "bar");
  EXPECT_EQ(scene.plucks[0].place.at, Vector3(4, 5, 6));
  EXPECT_EQ(scene.plucks[0].place.radius, 0.1);
  EXPECT_EQ(scene.plucks[0].force, Vector3(0, 7, 0));
}

TEST_F(ReadDeck, ReadsSettings) {
  const Scene scene = read(plate +
                           "audio: {rate: 96000, max_frequency: 20e3, kernel_wavelengths: 6, dc_block: 0}\n"
                           "radiation: {model: huygens, air: {density: 1000, speed: 1480}}\n"
                           "output: {frames_per_second: 0, motion_per_second: 100, wav: pcm24, wav_full_scale: 20, "
                           "checkpoint: {every_minutes: 0.5, keep: 1}}\n"
                           "references: {second: [880, 1760], \"first (Leissa)\": [440]}\n");
  EXPECT_EQ(scene.audio.rate, 96000);
  EXPECT_EQ(scene.audio.max_frequency, 20e3);
  EXPECT_EQ(scene.audio.kernel_wavelengths, 6.0);
  EXPECT_EQ(scene.audio.dc_loss, 0.0);
  EXPECT_EQ(scene.radiation.air.density, 1000.0);
  EXPECT_EQ(scene.radiation.air.speed, 1480.0);
  EXPECT_EQ(scene.output.frames_per_second, 0.0);
  EXPECT_EQ(scene.output.motion_per_second, 100.0);
  EXPECT_EQ(scene.output.wav, WavFormat::pcm24);
  EXPECT_EQ(scene.output.wav_full_scale, 20.0);
  EXPECT_EQ(scene.output.checkpoint_minutes, 0.5);
  EXPECT_EQ(scene.output.checkpoint_keep, 1);
  ASSERT_EQ(scene.references.size(), 2U);
  EXPECT_EQ(scene.references[0].name, "second");
  EXPECT_THAT(scene.references[0].frequencies, testing::ElementsAre(880.0, 1760.0));
  EXPECT_EQ(scene.references[1].name, "first (Leissa)");
}

TEST_F(ReadDeck, KeepsTheTextToTheByte) {
  const std::string text =
      "# Gr\xC3\xBC\xC3\x9F"
      "e\r\n" +
      replaced(plate, "\n", "\r\n") + "\r\n\t\n# end";
  EXPECT_EQ(read(text).deck_text, text);
  EXPECT_EQ(read(text).name, "plate");
}

TEST(ShippedDecks, AreRead) {
  for (const auto& entry : std::filesystem::recursive_directory_iterator(IDIOPHONE_SOURCE_DIR "/inputs")) {
    const std::filesystem::path& path = entry.path();
    const std::filesystem::path folder = path.parent_path().filename();
    const std::set<std::string> folders = {"timbre", "ideal", "bowed", "struck", "touching"};
    const std::set<std::string> scores = {"blow.yaml", "stone.yaml", "floor.yaml"};
    const bool other = folders.contains(folder) || path.filename() == "tree.yaml" || scores.contains(path.filename());
    if (path.extension() == ".yaml" && !other) {  // sonic scenes, ideal bodies and scores are no decks
      EXPECT_NO_THROW(static_cast<void>(read_deck(path, {}))) << path;
    }
  }
}

}  // namespace idiophone::scene
