// `idiophone play`: plays bodies by their sound maps.

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <thread>

#include "command.hpp"
#include "idiophone/instruments/drivers/midi.hpp"
#include "idiophone/instruments/drivers/osc.hpp"
#include "idiophone/instruments/outputs/audio_output.hpp"
#include "idiophone/instruments/sound_maps/sound_map_file.hpp"
#include "idiophone/instruments/voices/performance.hpp"
#include "idiophone/run/loop/stop.hpp"
#include "idiophone/run/loop/wav_files.hpp"

namespace idiophone::app {

namespace {

struct PlayOptions {
  std::vector<std::filesystem::path> maps;  ///< sound maps
  std::filesystem::path score;              ///< if any
  std::vector<std::string> overrides;       ///< of the score
  std::optional<int> osc;                   ///< UDP port
  std::string midi;                         ///< a MIDI file, or jack
  std::filesystem::path output;             ///< WAV file to write; empty: the audio device plays
  std::string device;                       ///< part of its name; empty for the default one
  int rate = 48000;                         ///< audio samples per second
  int frames = 128;                         ///< of a block of the audio device
  double full_scale = 1.0;                  ///< of the audio device, Pa
};

void declare(CLI::App& app, PlayOptions& options) {
  app.add_option("maps", options.maps, "sound maps")->required();
  app.add_option("--score", options.score, "what is played and when, a YAML file (docs/use/play.md)");
  add_overrides(app, options.overrides);
  app.add_option("--osc", options.osc, "UDP port for OSC messages")->check(CLI::Range(1, 65535));
  app.add_option("--midi", options.midi, "a MIDI file, or jack: notes from JACK's MIDI");
  add_output_file(app, options.output, "WAV file to write instead of playing");
  app.add_option("--device", options.device, "part of the audio device's name, e.g. JACK (default: the system's)");
  app.add_option("--rate", options.rate, "audio samples per second")
      ->check(CLI::Range(8000, 192000))
      ->capture_default_str();
  app.add_option("--frames", options.frames, "audio samples that the device asks for at once")
      ->check(CLI::Range(16, 8192))
      ->capture_default_str();
  app.add_option("--full-scale", options.full_scale, "Pa: pressure of the device's loudest sample")
      ->check(CLI::Range(1e-9, 1e9))
      ->capture_default_str();
}

constexpr const char* jack_as_midi = "jack";

std::vector<sound_maps::SoundMap> read_maps(const std::vector<std::filesystem::path>& files) {
  std::vector<sound_maps::SoundMap> maps;
  for (const std::filesystem::path& file : files) {
    sound_maps::SoundMap map = sound_maps::read_sound_map(file);
    if (std::ranges::find(maps, map.body, &sound_maps::SoundMap::body) != maps.end()) {
      throw std::runtime_error(fmt::format("{}: there is another body with the name {}", file.string(), map.body));
    }
    maps.push_back(std::move(map));
  }
  return maps;
}

std::vector<std::string> bodies_of(const std::vector<sound_maps::SoundMap>& maps) {
  std::vector<std::string> bodies;
  std::ranges::transform(maps, std::back_inserter(bodies), &sound_maps::SoundMap::body);
  return bodies;
}

void check_options(const PlayOptions& options) {
  if (options.score.empty() && options.midi.empty() && !options.osc) {
    throw std::runtime_error("there is nothing to play; give --score, --midi or --osc");
  }
  if (options.score.empty() && !options.midi.empty()) {
    throw std::runtime_error("--midi needs a score whose notes say what is struck (docs/use/play.md)");
  }
  if (!options.output.empty() && (options.osc || options.midi == jack_as_midi)) {
    throw std::runtime_error("--output writes what a score or a MIDI file says; leave out --osc and --midi jack");
  }
}

void write_file(voices::Performance& performance, const PlayOptions& options) {
  const score::Score& score = performance.score();
  loop::require_room_for_wav(options.output,
                             score.duration * options.rate * static_cast<double>(performance.receivers()));
  const auto begin = std::chrono::steady_clock::now();
  const std::vector<double> sound = voices::rendered(performance, std::llround(score.duration * options.rate));
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
  loop::write_wav(options.output, sound,
                  {.rate = options.rate,
                   .channels = static_cast<int>(performance.receivers()),
                   .format = score.wav,
                   .full_scale = score.wav_full_scale,
                   .full_scale_key = "wav_full_scale"});
  spdlog::info("{} modes; {:.4g} s of sound in {:.3g} s", performance.modes(), score.duration, taken.count());
}

void report(const outputs::AudioReport& audio, const voices::Performance& performance, const PlayOptions& options) {
  const double block = static_cast<double>(options.frames) / options.rate;
  spdlog::info("{} blocks of {} frames; load {:.3g} %, largest {:.3g} %; {} late blocks", audio.blocks, options.frames,
               100.0 * audio.mean_load, 100.0 * audio.largest_load, audio.late);
  if (const voices::Waits waits = performance.waits(); waits.count > 0) {
    // The block that a blow begins in is heard after it is computed: one block more.
    spdlog::info("from a blow to its sound: {:.3g} blocks on average, at most {:.3g} ({:.3g} ms)",
                 waits.mean / block + 1.0, waits.longest / block + 1.0, 1e3 * (waits.longest + block));
  }
  if (audio.clipped > 0) {
    spdlog::warn("{} samples exceed full scale and were clipped; raise --full-scale", audio.clipped);
  }
}

/// Plays until the score is over, or a signal comes if there is live input.
void play_live(voices::Performance& performance, const std::vector<std::string>& bodies, const PlayOptions& options) {
  constexpr double horizon = 0.2;  // s by which a score is sent ahead
  constexpr auto pause = std::chrono::microseconds(200);
  const bool is_live = options.osc || options.midi == jack_as_midi;
  const std::int64_t end = std::llround(performance.score().duration * options.rate);
  std::optional<drivers::JackMidi> midi;
  if (options.midi == jack_as_midi) {
    midi.emplace();
  }
  std::optional<drivers::OscServer> osc;
  if (options.osc) {
    osc.emplace(*options.osc, bodies,
                drivers::OscActions{.play = [&](const score::ScoreEvent& event) { performance.play(event); },
                                    .move_listener = [&](const Vector3& place) { performance.move_listener(place); }});
  }
  performance.feed(std::llround(horizon * options.rate));
  outputs::AudioOutput audio(
      performance,
      {.device = options.device, .frames = static_cast<std::size_t>(options.frames), .full_scale = options.full_scale});
  spdlog::info("{}: {} modes, {} channels, {} Hz, latency {:.3g} ms; Ctrl-C ends", audio.device(), performance.modes(),
               performance.receivers(), options.rate, 1e3 * audio.report().output_latency);
  std::size_t unknown_notes = 0;
  loop::watch_signals(loop::OnSignal::note);
  while (loop::noted_signal() == 0 && (is_live || performance.now() < end) && audio.report().running) {
    if (osc) {
      osc->poll();
    }
    for (drivers::Note note; midi && midi->take(note);) {
      unknown_notes += performance.play(note) ? 0 : 1;
    }
    performance.feed(performance.now() + std::llround(horizon * options.rate));
    std::this_thread::sleep_for(pause);
  }
  const outputs::AudioReport final_report = audio.report();
  report(final_report, performance, options);
  if (unknown_notes > 0) {
    spdlog::warn("{} MIDI notes that the score has nothing for", unknown_notes);
  }
  if (!final_report.running) {
    throw std::runtime_error(audio.device() + ": the device or its server stopped");
  }
}

int play(const PlayOptions& options) {
  check_options(options);
  std::vector<sound_maps::SoundMap> maps = read_maps(options.maps);
  const std::vector<std::string> bodies = bodies_of(maps);
  score::Score score;
  if (!options.score.empty()) {
    score = score::read_score(options.score, bodies, options.overrides);
  }
  voices::Performance performance(std::move(maps), std::move(score), options.rate);
  if (!options.midi.empty() && options.midi != jack_as_midi) {
    if (const std::size_t unknown = performance.add(drivers::read_midi_file(options.midi)); unknown > 0) {
      spdlog::warn("{}: {} notes that the score has nothing for", options.midi, unknown);
    }
  }
  if (options.output.empty()) {
    play_live(performance, bodies, options);
  } else {
    write_file(performance, options);
  }
  return loop::exit_finished;
}

}  // namespace

Command play_command() {
  return make_command<PlayOptions>("play", "play sound maps in real time, or write the sound to a file", Ranks::one,
                                   declare, play);
}

}  // namespace idiophone::app
