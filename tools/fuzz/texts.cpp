#include <array>
#include <fstream>

#include "idiophone/foundation/deck/tree.hpp"
#include "idiophone/instruments/score/score.hpp"
#include "idiophone/instruments/sound_maps/ideal_deck.hpp"
#include "idiophone/scene/resolved_deck.hpp"
#include "idiophone/scene/scene.hpp"
#include "idiophone/study/bench/cut_list.hpp"
#include "idiophone/study/fitting/measurements.hpp"
#include "idiophone/study/measured_maps/measured_deck.hpp"
#include "idiophone/timbre/language/live_sound.hpp"
#include "idiophone/timbre/sonic_scene/sonic_scene.hpp"
#include "readers.hpp"
#include "velocity_file.hpp"

namespace idiophone::fuzz {

namespace {

using File = std::filesystem::path;

void read_deck(const File& file) {
  static_cast<void>(scene::read_deck(file));
  static_cast<void>(scene::resolved_deck(file));
}

const std::string head =
    "name: plate\ntime: {duration: 0.01}\nmaterials: {metal: {young: 2e11, poisson: 0.3, density: 7850}}\n"
    "bodies: {plate: {mesh: seam.geo, material: metal}}\n"
    "listeners: {ear: {type: mono, position: [0, 0, 1]}}\n";

/// The table of a force, in a deck that has no other mistake.
void read_table(const File& file) {
  const File deck = file.parent_path() / "deck_of_table.yaml";
  std::ofstream(deck) << head << "loads: {tap: {body: plate, at: [0, 0, 0], force: [0, 0, -1], shape: table, table: "
                      << file.filename().string() << "}}\n";
  static_cast<void>(scene::read_deck(deck));
}

/// What a deck takes from a glTF file besides its shape.
void read_gltf(const File& file) {
  const File deck = file.parent_path() / "deck_of_gltf.yaml";
  std::ofstream(deck) << "name: cup\ntime: {duration: 0.01}\n"
                         "listeners: {ear: {type: mono, position: [0, 0, 1]}}\n"
                         "bodies: {cup: {mesh: "
                      << file.filename().string() << "}}\n";
  static_cast<void>(scene::read_deck(deck));
}

/// The value of `--set`.
void read_override(const File& file) {
  const File deck = file.parent_path() / "deck_of_override.yaml";
  std::ofstream(deck) << head;
  static_cast<void>(scene::read_deck(deck, {deck::read_text(file)}));
}

void read_score(const File& file) {
  static_cast<void>(score::read_score(file, {"plate"}, {}));
}

void read_event(const File& file) {
  static_cast<void>(score::read_event(deck::read_text(file), file.string(), {"plate", "bar"}));
}

void read_ideal(const File& file) {
  static_cast<void>(sound_maps::has_ideal_bodies(file, {}));
  static_cast<void>(sound_maps::read_ideal_deck(file, {}));
  static_cast<void>(sound_maps::resolved_ideal_deck(file, {}));
}

void read_lines(const File& file) {
  static_cast<void>(fitting::read_measurements(file));
}

/// What was cut from a bar of 340 mm, as the bench reads it.
void read_cuts(const File& file) {
  static_cast<void>(bench::read_past(file, bench::Side{}, {-0.17, 0.17}));
}

void read_measured(const File& file) {
  static_cast<void>(measured_maps::read_measured_deck(file, {}));
}

void read_velocities(const File& file) {
  deck::Mistakes mistakes;
  static_cast<void>(harmonic::csv_velocities(file, mistakes));
  mistakes.raise();
}

void read_scene(const File& file) {
  static_cast<void>(timbre::read_sonic_scene(file, {}));
}

/// Reads a timbre tree and computes some of its sound.
void read_tree(const File& file) {
  const timbre::Tree tree = timbre::read_tree_file(file);
  timbre::LiveSoundOptions options;
  for (const auto& parameter : tree.parameters) {
    options.constants[parameter.name] = 1.0;
  }
  std::array<double, 400> samples{};
  timbre::LiveSound(tree, options).render(samples);
}

}  // namespace

std::vector<Reader> text_readers() {
  std::vector<Reader> readers = {{"deck", ".yaml", read_deck, mutants::mutated_text},
                                 {"table", ".csv", read_table, mutants::mutated_text},
                                 {"score", ".yaml", read_score, mutants::mutated_text},
                                 {"event", ".yaml", read_event, mutants::mutated_text},
                                 {"ideal", ".yaml", read_ideal, mutants::mutated_text},
                                 {"lines", ".yaml", read_lines, mutants::mutated_text},
                                 {"cuts", ".yaml", read_cuts, mutants::mutated_text},
                                 {"measured", ".yaml", read_measured, mutants::mutated_text},
                                 {"velocities", ".csv", read_velocities, mutants::mutated_text},
                                 {"sonic_scene", ".yaml", read_scene, mutants::mutated_text},
                                 {"timbre_tree", ".tt", read_tree, mutants::mutated_text},
                                 {"gltf", ".gltf", read_gltf, mutants::mutated_text}};
  readers.push_back({"override", ".txt", read_override, mutants::mutated_text, false});
  return readers;
}

}  // namespace idiophone::fuzz
