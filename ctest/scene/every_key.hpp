#pragma once
// docs/use/deck.md, and a deck in which each of its sections occurs.

#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <sstream>
#include <string>

#include "deck_fixture.hpp"

namespace idiophone::scene {

inline std::string deck_page() {
  std::ifstream file(IDIOPHONE_SOURCE_DIR "/docs/use/deck.md");
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Whether the page says a default, by section and key, from the columns of its tables.
inline std::map<std::string, std::map<std::string, bool>> documented_keys() {
  static const std::regex row(R"(\| (\*\*)?`(\w+)`(\*\*)? \|[^|]*\| ?(`?).*)");
  std::map<std::string, std::map<std::string, bool>> keys;
  std::istringstream lines(deck_page());
  std::string section;
  for (std::string line; std::getline(lines, line);) {
    std::smatch match;
    if (line.starts_with("## ")) {
      section = line.substr(3);
    }
    if (std::regex_match(line, match, row)) {
      keys[section][match[2]] = match[4].length() > 0;
    }
  }
  return keys;
}

constexpr const char* in_the_open = "floor: {at: [0, 0, -1]}";
constexpr const char* with_screens = "screens: {wall: {corners: [[0, 0, 3], [1, 0, 3], [0, 1, 3]]}}";
constexpr const char* in_a_room = "room: {size: [4, 4, 4], corner: [-2, -2, -2], absorption: 0.1}";

/// @param plate         the small deck of DeckTest
/// @param surroundings  keys of radiation: neither rooms nor screens have a floor besides
inline std::string every_key(const std::string& plate, const std::string& surroundings = in_the_open) {
  return DeckTest::replaced(
             DeckTest::replaced(
                 DeckTest::replaced(plate, "material: steel", "material: spruce, grain: {x: [1, 0, 0], y: [0, 1, 0]}"),
                 "fixed: [rim]",
                 "fixed: [{group: rim}],"
                 " driven: [{group: top, displacement: [0, 0, 1], duration: 1,"
                 " rotation: {axis: [1, 0, 0], degrees: 1, pivot: [0, 0, 0]}}],"
                 " element: hex, order: {plane: 3, thickness: 2}, mass_scaling: {shift: 2}, thickness: 0.001, model: "
                 "{type: finite_elements},"
                 " groups: {lid: {normal: [0, 0, 1]}},"
                 " supports: {cord: {at: [0, 0, 0], stiffness: 1}}, meshing: {time_limit: 60},"
                 " rotation: {axis: [1, 0, 0], degrees: 1}"),
             "loads:\n  tap: {",
             "  echo: {recording: plate.geo}\n"
             "  pane: {mesh: plate.geo, materials: {glass: {material: steel}}, fracture: [{surface: cracks, strength: "
             "1}]}\n"
             "  ply: {mesh: plate.geo, element: hex, fixed: [left], prestress: {xx: 1, stretch: {group: left, "
             "displacement: [1, 0, 0]}},"
             " layers: [{material: steel, thickness: 0.001}]}\n"
             "loads:\n  pull: {type: pluck, body: plate, at: [0, 0, 0], force: [0, 0, 1]}\n"
             "  breeze: {type: wind, velocity: [1, 0, 0]}\n"
             "  rub: {type: bow, body: plate, at: [0, 0, 0], direction: [1, 0, 0], speed: 1, load: 1}\n"
             "  tap: {body: plate, ") +
         "  ears: {type: stereo, position: [0, 0, 1], look: [0, 0, -1], up: [0, 1, 0]}\n"
         "  head: {type: binaural, position: [0, 0, 1], look: [0, 0, -1], up: [0, 1, 0]}\n"
         "obstacles:\n"
         "  floor: {shape: half_space, at: [0, 0, 0]}\n"
         "  block: {shape: box, at: [0, 0, 0], size: [1, 1, 1],"
         " rotation: {axis: [1, 0, 0], degrees: 1}}\n"
         "  ball: {shape: sphere, at: [0, 0, 0], radius: 1}\n"
         "  post: {shape: cylinder, at: [0, 0, 0], radius: 1, length: 1}\n"
         "  rock: {shape: surface, at: [0, 0, 0], mesh: plate.geo}\n"
         "contacts:\n"
         "  bounce: {between: [plate, floor], friction: {sticking: 1, sliding: 1}}\n"
         "  tip: {between: [plate, block], friction: {type: elasto_plastic}}\n"
         "  roll: {between: [plate, ball]}\n"
         "  ring: {between: [plate, post]}\n"
         "  drop: {between: [plate, rock]}\n"
         "joints:\n"
         "  glue: {between: [ply.top, ply.bottom], stiffness: {normal: 1, tangential: 1}}\n"
         "  rivet: {type: bolt, between: [ply.top, ply.bottom], at: [0, 0, 0], radius: 1}\n"
         "  coil: {type: spring, between: [ply.top, ply.bottom], stiffness: {axial: 1, lateral: 0}, at: [0, 0, 0]}\n"
         "  swing: {type: hinge, between: [ply.top, ply.bottom], axis: [[0, 0, 0], [1, 0, 0]],"
         " turning: {stiffness: 1}}\n"
         "gauges: {bow: {type: strain, points: [{body: plate, at: [0, 0, 0]}, {body: plate, at: [1, 0, 0]}]}}\n"
         "radiation: {model: kirchhoff, " +
         surroundings + "}\n";
}

/// Where each section of the page is in that deck.
inline const std::map<std::string, std::string>& every_path() {
  static const std::map<std::string, std::string> paths = {
      {"deck", ""},
      {"time", "time"},
      {"materials.NAME", "materials.steel"},
      {"materials.NAME.damping", "materials.steel.damping"},
      {"bodies.NAME", "bodies.plate"},
      {"bodies.NAME, recorded", "bodies.echo"},
      {"bodies.NAME.meshing", "bodies.plate.meshing"},
      {"bodies.NAME.materials.GROUP", "bodies.pane.materials.glass"},
      {"bodies.NAME.layers.INDEX", "bodies.ply.layers.0"},
      {"bodies.NAME.prestress", "bodies.ply.prestress"},
      {"bodies.NAME.prestress.stretch", "bodies.ply.prestress.stretch"},
      {"bodies.NAME.grain", "bodies.plate.grain"},
      {"bodies.NAME.order", "bodies.plate.order"},
      {"bodies.NAME.model", "bodies.plate.model"},
      {"bodies.NAME.mass_scaling", "bodies.plate.mass_scaling"},
      {"bodies.NAME.fixed.INDEX", "bodies.plate.fixed.0"},
      {"bodies.NAME.driven.INDEX", "bodies.plate.driven.0"},
      {"bodies.NAME.driven.INDEX.rotation", "bodies.plate.driven.0.rotation"},
      {"bodies.NAME.groups.NAME", "bodies.plate.groups.lid"},
      {"bodies.NAME.supports.NAME", "bodies.plate.supports.cord"},
      {"bodies.NAME.fracture.INDEX", "bodies.pane.fracture.0"},
      {"obstacles.NAME, shape: half_space", "obstacles.floor"},
      {"obstacles.NAME, shape: box", "obstacles.block"},
      {"obstacles.NAME.rotation", "obstacles.block.rotation"},
      {"obstacles.NAME, shape: sphere", "obstacles.ball"},
      {"obstacles.NAME, shape: cylinder", "obstacles.post"},
      {"obstacles.NAME, shape: surface", "obstacles.rock"},
      {"contacts.NAME", "contacts.bounce"},
      {"contacts.NAME.friction", "contacts.bounce.friction"},
      {"contacts.NAME.friction, type: elasto_plastic", "contacts.tip.friction"},
      {"joints.NAME, type: glue", "joints.glue"},
      {"joints.NAME, type: bolt", "joints.rivet"},
      {"joints.NAME, type: spring", "joints.coil"},
      {"joints.NAME, type: hinge", "joints.swing"},
      {"joints.NAME.turning", "joints.swing.turning"},
      {"joints.NAME.stiffness", "joints.glue.stiffness"},
      {"joints.NAME.stiffness, type: spring", "joints.coil.stiffness"},
      {"loads.NAME, type: pulse", "loads.tap"},
      {"loads.NAME, type: pluck", "loads.pull"},
      {"loads.NAME, type: wind", "loads.breeze"},
      {"loads.NAME.gusts", "loads.breeze.gusts"},
      {"loads.NAME, type: bow", "loads.rub"},
      {"loads.NAME.friction", "loads.rub.friction"},
      {"gauges.NAME", "gauges.bow"},
      {"gauges.NAME.points.INDEX", "gauges.bow.points.0"},
      {"listeners.NAME, type: mono", "listeners.ear"},
      {"listeners.NAME, type: stereo", "listeners.ears"},
      {"listeners.NAME, type: binaural", "listeners.head"},
      {"audio", "audio"},
      {"radiation", "radiation"},
      {"radiation.visibility", "radiation.visibility"},
      {"radiation.air", "radiation.air"},
      {"radiation.floor", "radiation.floor"},
      {"radiation.room", "radiation.room"},
      {"radiation.screens.NAME", "radiation.screens.wall"},
      {"output", "output"},
      {"output.checkpoint", "output.checkpoint"}};
  return paths;
}

/// The deck with a section at a path.
inline std::string every_key_at(const std::string& plate, const std::string& path) {
  return every_key(plate, path == "radiation.room"                ? in_a_room
                          : path.starts_with("radiation.screens") ? with_screens
                                                                  : in_the_open);
}

}  // namespace idiophone::scene
