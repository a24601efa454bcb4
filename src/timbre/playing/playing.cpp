#include "idiophone/timbre/playing/playing.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <stdexcept>
#include <utility>

#include "cast.hpp"
#include "idiophone/instruments/outputs/audio_output.hpp"
#include "idiophone/instruments/outputs/written_sound.hpp"
#include "idiophone/run/loop/stop.hpp"
#include "playing_drivers.hpp"

namespace idiophone::timbre {

namespace {

constexpr int usual_rate = 48000;  // Hz

void check(const PlaySettings& settings) {
  if (settings.score.empty() && settings.midi.empty() && settings.contacts.empty() && !settings.osc) {
    throw std::runtime_error("there is nothing to play; give --score, --contacts, --midi or --osc");
  }
  if (settings.score.empty() && !settings.midi.empty()) {
    throw std::runtime_error("--midi needs a score whose notes say what is struck (docs/use/play.md)");
  }
  if (!settings.output.empty() && (settings.osc || settings.midi == jack_as_midi)) {
    throw std::runtime_error("--output writes what a score or a file says; leave out --osc and --midi jack");
  }
  if (!settings.midi_out.empty() && (settings.osc || settings.midi == jack_as_midi)) {
    throw std::runtime_error("--midi-out plays what a score or a file says; leave out --osc and --midi jack");
  }
  for (const std::filesystem::path& file : {settings.output, settings.proxies.report, settings.detail_report}) {
    if (!file.empty()) {
      loop::require_folder_of(file);
    }
  }
}

/// Where notes are all that is played, nothing may be left out silently.
void check_notes_alone(const PlaySettings& settings, const score::Score& score) {
  if (!settings.midi_out.empty() && settings.output.empty() &&
      (!settings.contacts.empty() || !settings.motion.empty() || !score.contacts.empty())) {
    throw std::runtime_error(
        "--midi-out sends notes; leave out --contacts, --motion and the score's `contacts`, or write their sound by "
        "--output");
  }
}

int rate_of(const PlaySettings& settings, const Cast& cast) {
  return settings.rate.value_or(cast.decks.empty() ? usual_rate : cast.decks.front().audio.rate);
}

score::Score score_of(const PlaySettings& settings, const Cast& cast) {
  if (!settings.score.empty()) {
    score::Score score = score::read_score(settings.score, cast.names(), settings.score_overrides);
    if (score.motion.empty() != settings.motion.empty()) {
      throw std::runtime_error("--motion is the result whose channels `motion` of the score follows; give both");
    }
    return score;
  }
  score::Score score;
  for (const scene::Scene& deck : cast.decks) {
    score.duration = std::max(score.duration, deck.time.duration);
  }
  return score;
}

std::unique_ptr<outputs::Output> output_of(const PlaySettings& settings, const score::Score& score,
                                           const StagedCast& staged, std::int64_t samples) {
  const voices::Stage& stage = *staged.stage;
  if (settings.output.empty()) {
    const std::string what = fmt::format("{} bodies, {} buffers of {} frames", stage.bodies().size(), settings.buffers,
                                         settings.buffer_frames);
    const outputs::AudioOptions options{.device = settings.device,
                                        .frames = static_cast<std::size_t>(settings.frames),
                                        .full_scale = settings.full_scale};
    return std::make_unique<outputs::DeviceOutput>(options, what, stage.rate());
  }
  const char* unit = settings.proxies.engine.sound == proxies::Sound::deviation ? "m3" : "Pa";
  if (settings.output.extension() == ".h5") {
    const auto add_film = [proxies = staged.proxies](results::ResultFile& result) {
      if (proxies != nullptr && proxies->film()) {
        write_film(*proxies->film(), result);
      }
    };
    return std::make_unique<outputs::ResultOutput>(settings.output, staged.origin, unit, stage.rate(), samples,
                                                   add_film);
  }
  const loop::WavSettings wav{.rate = stage.rate(),
                              .channels = static_cast<int>(stage.receivers()),
                              .format = score.wav,
                              .full_scale = score.wav_full_scale,
                              .full_scale_key = "wav_full_scale",
                              .unit = unit};
  return std::make_unique<outputs::WavOutput>(settings.output, wav, samples);
}

/// @return of the stage
voices::VoiceReport report(const PlaySettings& settings, const voices::Stage& stage, const drivers::Drivers& drivers) {
  voices::VoiceReport told = stage.report();
  if (told.waits.count > 0) {
    // The block that a blow begins in is heard after it is computed: one block more.
    const double block = static_cast<double>(settings.frames) / stage.rate();
    spdlog::info("from a blow to its sound: {:.3g} blocks on average, at most {:.3g} ({:.3g} ms)",
                 told.waits.mean / block + 1.0, told.waits.longest / block + 1.0, 1e3 * (told.waits.longest + block));
  }
  if (settings.output.empty()) {
    spdlog::info("{:.4g} s; {} gaps", static_cast<double>(stage.now()) / stage.rate(), told.gaps);
  }
  for (const std::string& doubt : told.doubts) {
    spdlog::warn("{}", doubt);
  }
  for (const auto& driver : drivers) {
    if (const std::string complaint = driver->complaint(); !complaint.empty()) {
      spdlog::warn("{}", complaint);
    }
  }
  return told;
}

/// The loop, with Ctrl-C as its end.
Performance perform(const PlaySettings& settings, const score::Score& score, const StagedCast& staged,
                    const drivers::Drivers& drivers) {
  voices::Stage& stage = *staged.stage;
  const std::int64_t samples = std::llround(score.duration * stage.rate());
  const std::unique_ptr<outputs::Output> output = output_of(settings, score, staged, samples);
  const bool is_live = settings.output.empty();
  if (is_live) {
    loop::watch_signals(loop::OnSignal::note);
  }
  const std::clock_t begin = std::clock();
  voices::perform(stage, drivers, *output, samples, [is_live] { return is_live && loop::noted_signal() != 0; });
  Performance done{.bodies = stage.bodies(),
                   .rate = stage.rate(),
                   .duration = is_live ? static_cast<double>(stage.now()) / stage.rate() : score.duration,
                   .processor_time = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC};
  if (!is_live) {
    spdlog::info("bodies: {}; {:.4g} s of sound in {:.3g} s of processor time", done.bodies.size(), done.duration,
                 done.processor_time);
  }
  done.told = report(settings, stage, drivers);
  return done;
}

std::vector<drivers::StruckBody> struck_bodies(const voices::Stage& stage) {
  std::vector<drivers::StruckBody> bodies;
  for (std::size_t body = 0; body < stage.bodies().size(); ++body) {
    bodies.push_back({.name = stage.bodies()[body], .centre = stage.centre(body)});
  }
  return bodies;
}

/// The sound, to a file or an audio device.
Performance sound(const PlaySettings& settings, Cast cast, score::Score score) {
  const int rate = rate_of(settings, cast);
  StagedCast staged = timbre::staged(std::move(cast), settings, score, rate, settings.output.empty());
  for (const score::ScoreEvent& event : score.events) {
    if (const auto* tuning = std::get_if<score::Tuning>(&event.action)) {
      staged.stage->require_tunable(event.body, *tuning);
    } else if (std::holds_alternative<score::Bow>(event.action) ||
               std::holds_alternative<score::MalletBlow>(event.action)) {
      staged.stage->require_touchable(event.body);
    }
  }
  drivers::Drivers drivers = known_drivers(settings, score, struck_bodies(*staged.stage), rate);
  add_players(settings, score, *staged.stage, drivers);
  Performance done = perform(settings, score, staged, drivers);
  staged.stage->end();
  if (staged.maps != nullptr) {
    done.maps = report_detail(*staged.maps, settings, rate);
  }
  if (staged.proxies != nullptr) {
    done.proxies = report_choices(*staged.proxies, settings.proxies, rate);
    done.proxies->levels = std::move(staged.levels);
  }
  return done;
}

}  // namespace

Performance play(const PlaySettings& settings) {
  check(settings);
  if (settings.proxies.frames_per_second > 0.0 &&
      (settings.output.extension() != ".h5" || settings.proxies.levels > 1)) {
    throw std::runtime_error("--frames-per-second needs --output FILE.h5, and bodies of one level: leave out --levels");
  }
  Cast cast = read_cast(settings);
  score::Score score = score_of(settings, cast);
  check_notes_alone(settings, score);
  Performance done;
  if (settings.midi_out.empty() || !settings.output.empty()) {
    done = sound(settings, std::move(cast), score);
  }
  if (!settings.midi_out.empty()) {
    done.midi_messages = send_notes(settings, score);
  }
  return done;
}

DrivenProxies driven_proxies(const PlaySettings& settings) {
  check(settings);
  Cast cast = read_cast(settings);
  DrivenProxies driven;
  driven.score = score_of(settings, cast);
  require_maps(cast, driven.score.contacts);
  driven.scene = std::move(cast.decks.front());
  driven.levels = levels_of_all(driven.scene, 1, settings.proxies.springs);
  std::vector<drivers::StruckBody> bodies;
  for (std::size_t body = 0; body < driven.scene.bodies.size(); ++body) {
    bodies.push_back(
        {.name = driven.scene.bodies[body].name, .centre = driven.levels[body].front()->body_inertia().centre});
  }
  driven.tracks.resize(bodies.size());
  if (!settings.contacts.empty()) {
    driven.tracks = drivers::body_tracks(settings.contacts, bodies);
  }
  std::vector<drivers::Event> events;
  for (const auto& driver : known_drivers(settings, driven.score, bodies, driven.scene.audio.rate)) {
    driver->ask(0, std::numeric_limits<std::int64_t>::max(), events);
  }
  for (const drivers::Event& event : events) {
    if (const auto* excitation = std::get_if<drivers::Excitation>(&event.action)) {
      for (const resonators::PointForce& force : excitation->forces) {
        driven.forces.push_back(voices::proxy_force(event.body, force));
      }
    } else if (std::holds_alternative<drivers::Touching>(event.action)) {
      throw std::runtime_error("only sound maps feel bows and mallets; " + bodies[event.body].name + " is none");
    }
  }
  return driven;
}

}  // namespace idiophone::timbre
