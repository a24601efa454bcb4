#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <thread>

#include "commands.hpp"
#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/instruments/drivers/midi.hpp"
#include "idiophone/instruments/drivers/osc.hpp"
#include "idiophone/instruments/outputs/audio_output.hpp"
#include "idiophone/instruments/sound_maps/sound_map_file.hpp"
#include "idiophone/instruments/voices/performance.hpp"
#include "idiophone/run/loop/stop.hpp"
#include "idiophone/run/loop/wav_files.hpp"

namespace idiophone::app {

namespace {

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
  if (parallel::size_of(MPI_COMM_WORLD) > 1) {
    throw std::runtime_error("play uses one process; start it without mpirun");
  }
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

}  // namespace

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

}  // namespace idiophone::app
