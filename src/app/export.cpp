// `idiophone export`: a sound map, a proxy or a timbre tree for other programs, and the sound power of a force.

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "command.hpp"
#include "idiophone/foundation/text_file.hpp"
#include "idiophone/instruments/sound_maps/blow.hpp"
#include "idiophone/instruments/sound_maps/exports.hpp"
#include "idiophone/instruments/sound_maps/radiated_power.hpp"
#include "idiophone/instruments/sound_maps/sound_map_file.hpp"
#include "idiophone/instruments/sound_maps/voice_file.hpp"
#include "idiophone/run/loop/stop.hpp"
#include "idiophone/timbre/export/tree_faust.hpp"
#include "map_warnings.hpp"
#include "proxy_export.hpp"

namespace idiophone::app {

namespace {

struct ExportOptions {
  std::filesystem::path source;     ///< NAME_BODY.map.h5, a timbre tree, TREE.tt, or a deck for a proxy
  std::filesystem::path faust;      ///< to write, if any
  std::filesystem::path gltf;       ///< to write, if any
  std::filesystem::path power;      ///< to write, if any
  std::filesystem::path voice;      ///< to write, if any
  std::vector<double> at;           ///< where the force acts in Faust and for the power, m; empty for the first vertex
  std::vector<double> direction;    ///< of that force; empty for down
  std::string listener;             ///< who hears it in Faust; empty for the first
  std::vector<double> frequencies;  ///< of the power, Hz; empty for those that show every peak
  ProxyExport proxy;
};

void declare(CLI::App& app, ExportOptions& options) {
  app.add_option("source", options.source, "NAME_BODY.map.h5, of `map`, a timbre tree, TREE.tt, or a deck for --proxy")
      ->required();
  app.add_option("--faust", options.faust, "FILE.dsp: a program in Faust, from force to pressure");
  app.add_option("--power", options.power, "FILE.csv: radiated sound power over the frequency of a force of 1 N, W");
  app.add_option("--frequencies", options.frequencies,
                 "HZ,HZ,... of --power (default: those of the modes, and 48 in an octave)")
      ->delimiter(',')
      ->allow_extra_args(false);
  app.add_option("--at", options.at,
                 "X,Y,Z: the force of --faust and --power acts there, m (default: the first vertex)")
      ->delimiter(',')
      ->expected(3);
  app.add_option("--direction", options.direction, "X,Y,Z of that force (default: 0,0,-1)")
      ->delimiter(',')
      ->expected(3);
  app.add_option("--listener", options.listener, "who hears it in Faust (default: the first)");
  app.add_option("--gltf", options.gltf, "FILE.gltf with the extension KHR_audio_rigid_bodies");
  app.add_option("--voice", options.voice, "FILE.voice: a flat file for the library of voices in engines");
  declare(app, options.proxy);
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

/// A body of a deck as a proxy.
int export_proxy(const ExportOptions& options) {
  if (!options.faust.empty() || !options.gltf.empty() || !options.power.empty() || !options.voice.empty()) {
    throw std::runtime_error(
        "--proxy exports a body of a deck; --faust, --gltf, --power and --voice do not go with it");
  }
  write_and_report(options.proxy.file, proxy_of_deck(options.source, options.proxy));
  return loop::exit_finished;
}

/// A timbre tree as a program in Faust.
int export_tree(const ExportOptions& options) {
  if (options.faust.empty() || !options.gltf.empty() || !options.power.empty() || !options.voice.empty()) {
    throw std::runtime_error("a timbre tree is exported by --faust FILE.dsp, without --gltf, --power and --voice");
  }
  write_and_report(options.faust, timbre::faust_program(options.source));
  return loop::exit_finished;
}

/// The force of 1 N that the options describe.
struct ExportForce {
  Vector3 at, direction;
  std::vector<double> participation;  ///< [modes]
};

ExportForce force_on(const sound_maps::SoundMap& map, const ExportOptions& options) {
  const Vector3 direction = vector_or(options.direction, {0, 0, -1});
  if (!(direction.norm() > 0.0)) {
    throw std::runtime_error("--direction must not be 0,0,0");
  }
  const Vector3 at = vector_or(options.at, map.vertices.front());
  return {at, direction, sound_maps::participation(map, at, direction.normalized())};
}

void export_faust(const sound_maps::SoundMap& map, const ExportOptions& options) {
  const auto [at, direction, participation] = force_on(map, options);
  const auto place = fmt::format("at ({:.6g}, {:.6g}, {:.6g}) m along ({:.6g}, {:.6g}, {:.6g})", at[0], at[1], at[2],
                                 direction[0], direction[1], direction[2]);
  write_and_report(options.faust,
                   sound_maps::faust_program(map, participation, find_listener(map, options.listener), place));
}

void export_power(const sound_maps::SoundMap& map, const ExportOptions& options) {
  for (const double frequency : options.frequencies) {
    if (!(frequency > 0.0 && std::isfinite(frequency))) {
      throw std::runtime_error(fmt::format("--frequencies must be above 0 Hz, not {}", frequency));
    }
  }
  const std::vector<double> frequencies =
      options.frequencies.empty() ? sound_maps::frequencies_with_peaks(map) : options.frequencies;
  const std::vector<double> power = sound_maps::radiated_power(map, force_on(map, options).participation, frequencies);
  std::string text = "# frequency/Hz, power/W\n";
  for (std::size_t i = 0; i < power.size(); ++i) {
    text += fmt::format("{}, {}\n", frequencies[i], power[i]);
  }
  write_and_report(options.power, text);
}

int export_source(const ExportOptions& options) {
  if (!options.proxy.file.empty()) {
    return export_proxy(options);
  }
  if (options.source.extension() == ".tt") {
    return export_tree(options);
  }
  if (options.faust.empty() && options.gltf.empty() && options.power.empty() && options.voice.empty()) {
    throw std::runtime_error(
        "nothing to do: give --faust FILE.dsp, --gltf FILE.gltf, --power FILE.csv or --voice FILE.voice; for a deck, "
        "--proxy FILE.proxy");
  }
  if (options.power.empty() && !options.frequencies.empty()) {
    throw std::runtime_error("--frequencies are those of --power FILE.csv; give both");
  }
  const sound_maps::SoundMap map = sound_maps::read_sound_map(options.source);
  if (!options.faust.empty() || !options.gltf.empty() || !options.power.empty()) {
    warn_of_small_vibrations(map, "an export");
  }
  if (!options.faust.empty()) {
    export_faust(map, options);
  }
  if (!options.power.empty()) {
    export_power(map, options);
  }
  if (!options.voice.empty()) {
    write_and_report(options.voice, sound_maps::voice_file(map));
  }
  if (!options.gltf.empty()) {
    write_and_report(options.gltf, sound_maps::gltf_file(map));
  }
  return loop::exit_finished;
}

}  // namespace

Command export_command() {
  return make_command<ExportOptions>(
      "export",
      "write a sound map for Faust, as glTF or for engines, its sound power, a proxy for engines, or a timbre tree for "
      "Faust",
      Ranks::one, declare, export_source);
}

}  // namespace idiophone::app
