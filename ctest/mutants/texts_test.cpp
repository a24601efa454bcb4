// Decks, tables, scores, events, sonic scenes, timbre trees and measured lines.

#include "every_key.hpp"
#include "fixture.hpp"
#include "idiophone/foundation/deck/tree.hpp"
#include "idiophone/instruments/score/score.hpp"
#include "idiophone/instruments/sound_maps/ideal_deck.hpp"
#include "idiophone/scene/resolved_deck.hpp"
#include "idiophone/study/fitting/deck_numbers.hpp"
#include "idiophone/study/fitting/measurements.hpp"
#include "idiophone/timbre/export/tree_faust.hpp"
#include "idiophone/timbre/sonic_scene/sonic_scene.hpp"
#include "idiophone/timbre/track/soundtrack.hpp"
#include "performance.hpp"
#include "small_map.hpp"

namespace idiophone::mutants {

namespace {

using Texts = Mutants;
using File = std::filesystem::path;

const std::string score =
    "duration: 0.3\n"
    "listener: {type: mono, position: [0, 0, 1]}\n"
    "events:\n"
    "  - {time: 0.001, at: [0.2, 0.1, 0.1], direction: [0, 0, -1], mass: 0.01, hardness: 1e8, speed: 1}\n"
    "  - {type: force, time: 0.002, at: [0.2, 0, 0], force: [0, 0, 1], shape: half_sine, duration: 1e-3}\n"
    "  - {type: scrape, time: 0.002, from: [0, 0, 0], to: [1, 0, 0], direction: [0, 0, -1], speed: 0.2, load: 1,\n"
    "     mass: 0.01, hardness: 1e9, friction: 0.2, roughness: {height: 1e-6}}\n"
    "  - {type: roll, time: 0.003, from: [0, 0, 0], to: [1, 0, 0], direction: [0, 0, -1], speed: 0.2, load: 0.5,\n"
    "     mass: 0.05, hardness: 1e10, size: 2e-4, roughness: {height: 1e-7, exponent: 1.5}}\n"
    "  - {type: tune, time: 0.004, size: 1.1, friction: 2}\n"
    "notes:\n"
    "  - {note: 60, at: [0.2, 0, 0], direction: [0, 0, -1], mass: 0.01, hardness: 1e8, speed: 1}\n";

TEST_F(Texts, Deck) {
  expect_answers({.type = "deck",
                  .originals = {made("small.yaml", plate), made("every_key.yaml", scene::every_key(plate))},
                  .mutate = mutate_text,
                  .read = [](const File& file) {
                    static_cast<void>(scene::read_deck(file));
                    static_cast<void>(scene::resolved_deck(file));
                  }});
}

TEST_F(Texts, NumbersOfADeck) {
  expect_answers({.type = "numbers",
                  .originals = {made("small.yaml", plate)},
                  .mutate = mutate_text,
                  .read = [](const File& file) {
                    static_cast<void>(fitting::number_at(file, {}, "materials.steel.young"));
                    static_cast<void>(fitting::with_numbers(file, {{"materials.steel.young", 1.9e11}}));
                  }});
}

TEST_F(Texts, Override) {
  const File deck = made("deck.yaml", plate);
  expect_answers({.type = "override",
                  .originals = {made("list.txt", "loads.tap.force=[0, 0, -3]"), made("key.txt", "time.duration=0.5"),
                                made("map.txt", "materials.steel.damping={mass: 2, stiffness: 1e-8}")},
                  .mutate = mutate_text,
                  .read = [&](const File& file) { static_cast<void>(scene::read_deck(deck, {deck::read_text(file)})); },
                  .named = "--set "});
}

TEST_F(Texts, Table) {
  expect_answers({.type = "table",
                  .originals = {made("force.csv", "# s, N\n0, 0\n0.001, 20.5\n0.0025, -1e-3 # comment\n0.5, 0\n")},
                  .mutate = mutate_text,
                  .read = [&](const File& file) {
                    const std::string table = "shape: table, table: " + file.filename().string();
                    static_cast<void>(read(replaced(plate, "duration: 1.0e-3", table)));
                  }});
}

TEST_F(Texts, IdealBodies) {
  expect_answers(
      {.type = "ideal_bodies",
       .originals = {made("ideal.yaml",
                          "name: ideal\n"
                          "ideal_bodies:\n"
                          "  drum: {type: membrane, polygon: [[0, 0], [1, 0], [1, 1], [0, 1]],"
                          " tension: 1.25e5, density: 0.25, friction: 0.002}\n"
                          "  string: {type: string, length: 0.65, width: 0.001, tension: 70,"
                          " density: 4.0e-4, position: [0, 2, 0]}\n"
                          "  ring: {type: membrane, radius: 1, holes: [{radius: 0.2, at: [0.1, 0]}],"
                          " tension: 1.25e5, density: '0.2*(1 + x^2*(y < 0))'}\n"
                          "  plate: {type: plate, length: 2, width: 1, stiffness: 3, density: 2, poisson: 0.2,"
                          " edges: [free, clamped, free, supported], size: 0.1,"
                          " holes: [{polygon: [[1, 0.2], [1.5, 0.2], [1.2, 0.7]], edges: clamped}]}\n"
                          "listeners:\n"
                          "  ear: {type: mono, position: [0, 0, 1]}\n")},
       .mutate = mutate_text,
       .read = [](const File& file) {
         static_cast<void>(sound_maps::has_ideal_bodies(file, {}));
         static_cast<void>(sound_maps::read_ideal_deck(file, {}));
         static_cast<void>(sound_maps::resolved_ideal_deck(file, {}));
       }});
}

TEST_F(Texts, Score) {
  expect_answers(
      {.type = "score", .originals = {made("score.yaml", score)}, .mutate = mutate_text, .read = [](const File& file) {
         const auto read = score::read_score(file, {"plate"}, {});
         voices::Performance performance({sound_maps::small_map()}, read, 44100);
         static_cast<void>(performance.rendered(500));
       }});
}

TEST_F(Texts, Event) {
  expect_answers({.type = "event",
                  .originals = {made("blow.yaml",
                                     "{at: [0, 0, 1], direction: [0, 0, 1], mass: 0.1, hardness: 1e8,"
                                     " speed: 1, body: plate}"),
                                made("force.yaml",
                                     "{type: force, at: [0, 0, 1], force: [0, 1, 1], shape: sine,"
                                     " frequency: 50, duration: 0.1, body: bar}")},
                  .mutate = mutate_text,
                  .read = [](const File& file) {
                    static_cast<void>(score::read_event(deck::read_text(file), file.string(), {"plate", "bar"}));
                  }});
}

TEST_F(Texts, SonicScene) {
  const auto trees = shipped({"inputs/timbre/bee.tt", "inputs/timbre/wind.tt", "inputs/timbre/chime.tt",
                              "inputs/timbre/hinge.tt", "inputs/timbre/collision.tt"});
  expect_answers(
      {.type = "sonic_scene",
       .originals = shipped({"inputs/timbre/bee.yaml", "inputs/timbre/wind.yaml", "inputs/timbre/chimes.yaml",
                             "inputs/timbre/lamp.yaml", "inputs/timbre/cubes.yaml", "inputs/timbre/wall.yaml"}),
       .mutate = mutate_text,
       .read = [](const File& file) { static_cast<void>(timbre::read_sonic_scene(file, {})); }});
}

TEST_F(Texts, Soundtrack) {
  const auto trees = shipped({"inputs/timbre/wind.tt"});
  expect_answers({.type = "soundtrack",
                  .originals = shipped({"inputs/timbre/wind.yaml"}),
                  .mutate = mutate_text,
                  .read = [](const File& file) {
                    const auto read = timbre::read_sonic_scene(file, {});
                    timbre::Soundtrack track(read.scene, read.seed);
                    timbre::add_sounds(track, read, timbre::MotionChannels({}));
                    static_cast<void>(track.render(0.01, read.reverberation));
                  }});
}

TEST_F(Texts, TimbreTree) {
  expect_answers({.type = "timbre_tree",
                  .originals = shipped({"inputs/timbre/wind.tt", "inputs/timbre/bee.tt", "inputs/timbre/collision.tt",
                                        "inputs/timbre/four_sines.tt"}),
                  .mutate = mutate_text,
                  .read = [](const File& file) {
                    const scene::Scene scene;
                    timbre::Soundtrack track(scene, 1);
                    const auto sound = track.instantiate_sound(track.timbre_tree(file));
                    track.start_sound(sound, 0.0, {});
                    static_cast<void>(track.render(0.01, {}));
                  }});
}

TEST_F(Texts, FaustOfATree) {
  expect_answers({.type = "faust",
                  .originals = shipped({"inputs/timbre/wind.tt", "inputs/timbre/collision.tt"}),
                  .mutate = mutate_text,
                  .read = [](const File& file) { static_cast<void>(timbre::faust_program(file)); }});
}

TEST_F(Texts, MeasuredLines) {
  expect_answers({.type = "lines",
                  .originals = {made("lines.yaml",
                                     "mass: 0.1\nuncertainty: 5\nlines: [202, {frequency: 405,"
                                     " uncertainty: 6, decay_time: 0.6}, 584]\n")},
                  .mutate = mutate_text,
                  .read = [](const File& file) { static_cast<void>(fitting::read_measurements(file)); }});
}

}  // namespace

}  // namespace idiophone::mutants
