// `idiophone timbre`: the sounds of a sonic scene, bound to motion.

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "command.hpp"
#include "idiophone/air/propagation/ears.hpp"
#include "idiophone/instruments/drivers/midi.hpp"
#include "idiophone/instruments/outputs/midi_output.hpp"
#include "idiophone/run/loop/stop.hpp"
#include "idiophone/run/loop/wav_files.hpp"
#include "idiophone/timbre/sonic_scene/sonic_scene.hpp"
#include "idiophone/timbre/track/sonic_sounds.hpp"

namespace idiophone::app {

namespace {

struct TimbreOptions {
  std::filesystem::path scene;   ///< a sonic scene
  std::filesystem::path result;  ///< NAME.h5 with the motion, if any
  std::vector<std::string> overrides;
  std::filesystem::path output;  ///< WAV file; empty for NAME.wav
  std::string midi_out;          ///< where the music is sent in real time: a MIDI input of JACK, or jack; may be empty
};

void declare(CLI::App& app, TimbreOptions& options) {
  app.add_option("scene", options.scene, "the sonic scene, a YAML file (docs/use/timbre.md)")->required();
  app.add_option("result", options.result, "NAME.h5 of a run, whose motion the sounds are bound to");
  add_overrides(app, options.overrides);
  add_output_file(app, options.output, "WAV file to write (default: NAME.wav of the scene)");
  app.add_option(
      "--midi-out", options.midi_out,
      "then plays the music in real time: part of the name of a MIDI input of JACK, or jack: what is connected to it");
}

/// NAME.wav for a single listener, NAME_LISTENER.wav for several.
std::filesystem::path sound_file(const std::filesystem::path& file, const std::vector<timbre::TrackSound>& sounds,
                                 const timbre::TrackSound& sound) {
  std::filesystem::path path = file;
  if (sounds.size() > 1) {
    path.replace_filename(file.stem().string() + "_" + sound.listener + file.extension().string());
  }
  return path;
}

void check_output(const std::filesystem::path& file, const timbre::SonicScene& scene) {
  std::size_t channels = 1;
  for (const scene::Listener& listener : scene.scene.listeners) {
    channels = std::max(channels, listener.receivers.size());
  }
  loop::require_room_for_wav(file, scene.duration * scene.scene.audio.rate * static_cast<double>(channels));
}

void write_track(const std::filesystem::path& file, const std::vector<timbre::TrackSound>& sounds,
                 const scene::Scene& scene) {
  for (const timbre::TrackSound& sound : sounds) {
    loop::write_wav(sound_file(file, sounds, sound), sound.samples,
                    {.rate = scene.audio.rate,
                     .channels = static_cast<int>(sound.channels),
                     .format = scene.output.wav,
                     .full_scale = scene.output.wav_full_scale,
                     .full_scale_key = "wav_full_scale"});
  }
}

/// The music that was written beside `file`, on another program or a device.
void play_music(std::filesystem::path file, const std::string& destination) {
  file.replace_extension(".mid");
  loop::watch_signals(loop::OnSignal::note);
  outputs::play_midi(drivers::read_midi_messages(file), destination == "jack" ? "" : destination,
                     [] { return loop::noted_signal() != 0; });
}

void check_scene(const std::filesystem::path& file) {
  if (file.extension() == ".tt") {
    throw std::runtime_error(
        fmt::format("{} is a timbre tree. A sonic scene says when it sounds (docs/use/timbre.md); `idiophone play {} "
                    "--score FILE` strikes it",
                    file.string(), file.string()));
  }
}

int timbre(const TimbreOptions& options) {
  check_scene(options.scene);
  const timbre::SonicScene scene = timbre::read_sonic_scene(options.scene, options.overrides);
  propagation::check_heads(scene.scene);
  const std::filesystem::path file =
      options.output.empty() ? std::filesystem::path(scene.scene.name + ".wav") : options.output;
  check_output(file, scene);
  if (!options.midi_out.empty() && !scene.music) {
    throw std::runtime_error(options.scene.string() + " has no `music` for --midi-out");
  }
  const timbre::MotionChannels motion(options.result.empty() ? std::nullopt : std::optional(options.result));
  timbre::write_music(scene, motion, file);
  write_track(file, timbre::rendered_sounds(scene, motion, loop::ProgressWish::automatic), scene.scene);
  if (!options.midi_out.empty()) {
    play_music(file, options.midi_out);
  }
  return loop::exit_finished;
}

}  // namespace

Command timbre_command() {
  return make_command<TimbreOptions>("timbre", "make the sounds and the music of a sonic scene, bound to motion",
                                     Ranks::one, declare, timbre);
}

}  // namespace idiophone::app
