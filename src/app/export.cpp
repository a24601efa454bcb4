// `idiophone export`: a sound map or a timbre tree in the languages of other programs.

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <stdexcept>

#include "command.hpp"
#include "idiophone/foundation/text_file.hpp"
#include "idiophone/instruments/sound_maps/blow.hpp"
#include "idiophone/instruments/sound_maps/exports.hpp"
#include "idiophone/instruments/sound_maps/sound_map_file.hpp"
#include "idiophone/run/loop/stop.hpp"
#include "idiophone/timbre/export/tree_faust.hpp"

namespace idiophone::app {

namespace {

struct ExportOptions {
  std::filesystem::path map;      ///< NAME_BODY.map.h5, or a timbre tree, TREE.tt
  std::filesystem::path faust;    ///< to write, if any
  std::filesystem::path gltf;     ///< to write, if any
  std::vector<double> at;         ///< where a body is struck in Faust, m; empty for the first vertex
  std::vector<double> direction;  ///< of the force in Faust; empty for down
  std::string listener;           ///< who hears it in Faust; empty for the first
};

void declare(CLI::App& app, ExportOptions& options) {
  app.add_option("map", options.map, "NAME_BODY.map.h5, of `map`, or a timbre tree, TREE.tt")->required();
  app.add_option("--faust", options.faust, "FILE.dsp: a program in Faust, from force to pressure");
  app.add_option("--at", options.at, "X,Y,Z: struck there in Faust, m (default: the first vertex)")
      ->delimiter(',')
      ->expected(3);
  app.add_option("--direction", options.direction, "X,Y,Z of the force in Faust (default: 0,0,-1)")
      ->delimiter(',')
      ->expected(3);
  app.add_option("--listener", options.listener, "who hears it in Faust (default: the first)");
  app.add_option("--gltf", options.gltf, "FILE.gltf with the extension KHR_audio_rigid_bodies");
}

/// @param values  three numbers, or none
Vector3 vector_or(const std::vector<double>& values, const Vector3& otherwise) {
  return values.empty() ? otherwise : Vector3(values[0], values[1], values[2]);
}

std::size_t find_listener(const sound_maps::SoundMap& map, const std::string& name) {
  const auto found =
      name.empty() ? map.listeners.begin() : std::ranges::find(map.listeners, name, &sound_maps::MapListener::name);
  if (found == map.listeners.end()) {
    std::vector<std::string> names;
    std::ranges::transform(map.listeners, std::back_inserter(names), &sound_maps::MapListener::name);
    throw std::runtime_error(
        fmt::format("there is no listener '{}' in the map; it has: {}", name, fmt::join(names, ", ")));
  }
  return static_cast<std::size_t>(found - map.listeners.begin());
}

void write_and_report(const std::filesystem::path& path, const std::string& text) {
  write_text(path, text);
  spdlog::info("{}: {} bytes", path.string(), text.size());
}

/// A timbre tree as a program in Faust.
int export_tree(const ExportOptions& options) {
  if (options.faust.empty() || !options.gltf.empty()) {
    throw std::runtime_error("a timbre tree is exported by --faust FILE.dsp, without --gltf");
  }
  write_and_report(options.faust, timbre::faust_program(options.map));
  return loop::exit_finished;
}

int export_map(const ExportOptions& options) {
  if (options.map.extension() == ".tt") {
    return export_tree(options);
  }
  if (options.faust.empty() && options.gltf.empty()) {
    throw std::runtime_error("nothing to do: give --faust FILE.dsp or --gltf FILE.gltf");
  }
  const sound_maps::SoundMap map = sound_maps::read_sound_map(options.map);
  if (!options.faust.empty()) {
    const Vector3 direction = vector_or(options.direction, {0, 0, -1});
    if (!(direction.norm() > 0.0)) {
      throw std::runtime_error("--direction must not be 0,0,0");
    }
    const Vector3 at = vector_or(options.at, map.vertices.front());
    const auto place = fmt::format("at ({:.6g}, {:.6g}, {:.6g}) m along ({:.6g}, {:.6g}, {:.6g})", at[0], at[1], at[2],
                                   direction[0], direction[1], direction[2]);
    write_and_report(options.faust,
                     sound_maps::faust_program(map, sound_maps::participation(map, at, direction.normalized()),
                                               find_listener(map, options.listener), place));
  }
  if (!options.gltf.empty()) {
    write_and_report(options.gltf, sound_maps::gltf_file(map));
  }
  return loop::exit_finished;
}

}  // namespace

Command export_command() {
  return make_command<ExportOptions>("export", "write a sound map for Faust or as glTF, or a timbre tree for Faust",
                                     Ranks::one, declare, export_map);
}

}  // namespace idiophone::app
