// `idiophone proxies`: the sound of bodies by mass-spring proxies with levels of detail.

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "command.hpp"
#include "idiophone/instruments/drivers/proxy_contacts.hpp"
#include "idiophone/instruments/drivers/proxy_events.hpp"
#include "idiophone/instruments/proxies/engine.hpp"
#include "idiophone/instruments/proxy_bodies/proxy_bodies.hpp"
#include "idiophone/instruments/proxy_bodies/proxy_source.hpp"
#include "idiophone/instruments/score/score.hpp"
#include "idiophone/run/bodies/finite_element_source.hpp"
#include "idiophone/run/bodies/read_run_deck.hpp"
#include "idiophone/run/loop/job.hpp"
#include "idiophone/run/loop/output_lock.hpp"
#include "idiophone/run/loop/stop.hpp"
#include "idiophone/run/loop/wav_files.hpp"
#include "idiophone/scene/resolved_deck.hpp"
#include "proxies_live.hpp"

namespace idiophone::app {

namespace {

struct ProxiesOptions {
  std::filesystem::path deck;
  std::vector<std::string> overrides;
  std::filesystem::path score;     ///< what is done to the bodies, if any
  std::filesystem::path contacts;  ///< result of the deck's run whose contact forces drive the proxies, if any
  std::filesystem::path output;    ///< WAV file; empty: the audio device plays
  std::filesystem::path result;    ///< folder for a result by the radiation model of the deck, if any
  LiveProxies live;                ///< if the audio device plays
  std::filesystem::path report;    ///< CSV file for the choices of levels, if any
  int levels = 1;                  ///< meshes of each body, each with elements twice as large as the one before
  int lowest_rate = 1;             ///< the audio rate over this power of two
  int most_active = 8;             ///< proxies that may sound at once
  std::optional<double> budget;    ///< processor time per time of sound
  double speed = 4e8;              ///< springs that one core computes in a second, for the budget
  proxies::Priority priority = proxies::Priority::distance;
  proxies::Integrator integrator = proxies::Integrator::symplectic_euler;
  proxies::Sound sound = proxies::Sound::pressure;
  double significant_distance = 1e-10;  ///< m
};

void declare(CLI::App& app, ProxiesOptions& options) {
  add_deck(app, options.deck, options.overrides);
  app.add_option("--score", options.score, "what is done to the bodies, a YAML file (docs/use/play.md)");
  app.add_option("--contacts", options.contacts, "NAME.h5 of a run of the deck: its contact forces drive the proxies");
  add_output_file(app, options.output, "WAV file to write instead of playing");
  app.add_option("--output-folder", options.result,
                 "folder for NAME.h5 and its WAV files: the sound by the radiation model of the deck");
  add_renamed(app, "--result", "--output-folder");
  app.add_option("--osc", options.live.osc, "UDP port for OSC messages")->check(CLI::Range(1, 65535));
  app.add_option("--device", options.live.device, "part of the audio device's name (default: the system's)");
  app.add_option("--frames", options.live.frames, "audio samples in a buffer")
      ->check(CLI::Range(16, 8192))
      ->capture_default_str();
  app.add_option("--buffers", options.live.buffers, "that are computed ahead")
      ->check(CLI::Range(2, 1000))
      ->capture_default_str();
  app.add_option("--full-scale", options.live.full_scale, "Pa: pressure of the device's loudest sample")
      ->check(CLI::Range(1e-9, 1e9))
      ->capture_default_str();
  app.add_option("--report", options.report, "CSV file for the choices of levels over time");
  app.add_option("--levels", options.levels, "meshes of each body, each with elements twice as large as the one before")
      ->check(CLI::Range(1, 6))
      ->capture_default_str();
  app.add_option("--lowest-rate", options.lowest_rate, "of a body: the audio rate over this power of two")
      ->check(CLI::IsMember({1, 2, 4, 8, 16}))
      ->capture_default_str();
  app.add_option("--most-active", options.most_active, "proxies that may sound at once")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  app.add_option("--budget", options.budget, "processor time per time of sound (default: any)")
      ->check(CLI::Range(1e-6, 1e6));
  app.add_option("--speed", options.speed, "springs that one core computes in a second, for --budget")
      ->check(CLI::Range(1e3, 1e12))
      ->capture_default_str();
  const deck::Choices<proxies::Priority> priorities{{{"distance", proxies::Priority::distance},
                                                     {"loudness", proxies::Priority::loudness},
                                                     {"order", proxies::Priority::fixed}}};
  add_choice(app, "--priority", options.priority, priorities, "who may sound, and in which detail");
  const deck::Choices<proxies::Integrator> integrators{{{"symplectic_euler", proxies::Integrator::symplectic_euler},
                                                        {"improved_euler", proxies::Integrator::improved_euler}}};
  add_choice(app, "--integrator", options.integrator, integrators, "of the motion");
  const deck::Choices<proxies::Sound> sounds{
      {{"pressure", proxies::Sound::pressure}, {"deviation", proxies::Sound::deviation}}};
  add_choice(app, "--sound", options.sound, sounds, "what is heard of a proxy");
  app.add_option("--significant-distance", options.significant_distance, "m: masses that move less become stable")
      ->check(CLI::Range(1e-30, 1.0))
      ->capture_default_str();
}

void check_proxies(const ProxiesOptions& options) {
  if (options.score.empty() && options.contacts.empty() && !options.live.osc) {
    throw std::runtime_error("nothing drives the proxies; give --score, --contacts or --osc");
  }
  if (!options.result.empty() && (!options.output.empty() || options.levels > 1 || options.lowest_rate > 1)) {
    throw std::runtime_error(
        "--output-folder computes each body in full; leave out --output, --levels and --lowest-rate");
  }
  if ((!options.output.empty() || !options.result.empty()) && options.live.osc) {
    throw std::runtime_error("--output and --output-folder write what a score or a result says; leave out --osc");
  }
  for (const std::filesystem::path& file : {options.output, options.report}) {
    if (!file.empty()) {
      loop::require_folder_of(file);
    }
  }
}

std::vector<std::string> names_of(const scene::Scene& scene) {
  std::vector<std::string> names;
  std::ranges::transform(scene.bodies, std::back_inserter(names), &scene::Body::name);
  return names;
}

proxies::EngineOptions engine_options(const ProxiesOptions& options, const scene::Scene& scene) {
  proxies::EngineOptions chosen;
  chosen.rate = scene.audio.rate;
  chosen.integrator = options.integrator;
  chosen.significant_distance = options.significant_distance;
  chosen.sound = options.sound;
  chosen.air_density = scene.radiation.air.density;
  chosen.priority = options.priority;
  chosen.largest_divisor = options.lowest_rate;
  chosen.most_active = static_cast<std::size_t>(options.most_active);
  if (options.budget) {
    chosen.budget = *options.budget * options.speed;
  }
  return chosen;
}

/// The listener of the score, or the first one of the deck, at a time: the middle of its receivers.
Vector3 ear_of_proxies(const scene::Scene& scene, const score::Score& score, double time) {
  const scene::Listener& listener = score.listener ? *score.listener : scene.listeners.front();
  Vector3 sum = Vector3::Zero();
  for (const scene::Receiver& receiver : listener.receivers) {
    sum += listener.place(receiver, time).position;
  }
  return sum / static_cast<double>(listener.receivers.size());
}

using ProxyLevels = std::vector<std::shared_ptr<const proxies::Lattice>>;

std::vector<ProxyLevels> levels_of_all(const scene::Scene& scene, int levels) {
  std::vector<ProxyLevels> all;
  for (std::size_t body = 0; body < scene.bodies.size(); ++body) {
    all.push_back(proxy_bodies::proxy_levels(scene, body, levels));
    for (std::size_t level = 0; level < all.back().size(); ++level) {
      const proxies::Lattice& lattice = *all.back()[level];
      spdlog::info("{}, level {}: {} masses, {} springs, {} tetrahedra", scene.bodies[body].name, level,
                   lattice.masses().size(), lattice.springs().size(), lattice.mesh().tetrahedra.size());
    }
  }
  return all;
}

void add_bodies(const scene::Scene& scene, const std::vector<ProxyLevels>& levels, const Vector3& ear,
                proxies::Engine& engine) {
  for (std::size_t body = 0; body < scene.bodies.size(); ++body) {
    engine.add(proxies::BodyOptions{.name = scene.bodies[body].name,
                                    .levels = levels[body],
                                    .priority = -static_cast<double>(body),
                                    .listener = ear});
    for (std::size_t level = 0; level < levels[body].size(); ++level) {
      spdlog::info("{}, level {}: {:.3g} springs per second of sound", scene.bodies[body].name, level,
                   engine.cost(body, level, 1));
    }
  }
}

/// Of the score and of the contacts of a result.
std::vector<proxies::Force> driving_forces(const ProxiesOptions& options, const scene::Scene& scene,
                                           const score::Score& score, const std::vector<ProxyLevels>& levels) {
  std::vector<proxies::Force> forces;
  for (const score::ScoreEvent& event : score.events) {
    std::ranges::move(
        drivers::event_forces(event, std::llround(event.time * scene.audio.rate), score.seed, scene.audio.rate),
        std::back_inserter(forces));
  }
  if (!options.contacts.empty()) {
    std::vector<Vector3> centres;
    std::ranges::transform(levels, std::back_inserter(centres),
                           [](const ProxyLevels& body) { return body.front()->body_inertia().centre; });
    std::ranges::move(drivers::contact_forces(options.contacts, scene, centres), std::back_inserter(forces));
  }
  return forces;
}

/// All samples, without the engine's delay.
std::vector<double> rendered(const scene::Scene& scene, const score::Score& score, double duration,
                             proxies::Engine& engine) {
  constexpr std::size_t piece = 1024;  // audio samples in which the listener stays
  const auto delay = static_cast<std::size_t>(engine.delay());
  const auto samples = static_cast<std::size_t>(std::llround(duration * scene.audio.rate));
  const scene::Listener& listener = score.listener ? *score.listener : scene.listeners.front();
  std::vector<double> sound(samples + delay);
  for (std::size_t begin = 0; begin < sound.size(); begin += piece) {
    if (listener.path) {
      const Vector3 ear = ear_of_proxies(scene, score, static_cast<double>(begin) / scene.audio.rate);
      for (std::size_t body = 0; body < scene.bodies.size(); ++body) {
        engine.move_listener(body, ear);
      }
    }
    engine.render(std::span(sound).subspan(begin, std::min(piece, sound.size() - begin)));
  }
  sound.erase(sound.begin(), sound.begin() + static_cast<std::ptrdiff_t>(delay));
  return sound;
}

void write_proxies(const scene::Scene& scene, const score::Score& score, const ProxiesOptions& options,
                   proxies::Engine& engine) {
  loop::require_room_for_wav(options.output, score.duration * scene.audio.rate);
  const std::clock_t begin = std::clock();
  const std::vector<double> sound = rendered(scene, score, score.duration, engine);
  const double taken = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  loop::write_wav(options.output, sound,
                  {.rate = scene.audio.rate,
                   .channels = 1,
                   .format = score.wav,
                   .full_scale = score.wav_full_scale,
                   .full_scale_key = "wav_full_scale",
                   .unit = options.sound == proxies::Sound::deviation ? "m3" : "Pa"});
  spdlog::info("{:.4g} s of sound in {:.3g} s of processor time", score.duration, taken);
}

const char* name_of(proxies::Choice::Kind kind) {
  switch (kind) {
    case proxies::Choice::Kind::begin:
      return "begin";
    case proxies::Choice::Kind::end:
      return "end";
    case proxies::Choice::Kind::stop:
      return "stop";
    case proxies::Choice::Kind::refuse:
      return "refuse";
  }
  return "";
}

void write_choices(const std::filesystem::path& path, const std::vector<proxies::Choice>& choices,
                   const scene::Scene& scene) {
  std::ofstream file(path);
  file << "time,body,choice,level,rate,springs_per_second\n";
  for (const proxies::Choice& choice : choices) {
    file << fmt::format("{:.6f},{},{},{},{},{:.6g}\n", static_cast<double>(choice.sample) / scene.audio.rate,
                        scene.bodies[choice.body].name, name_of(choice.kind), choice.level,
                        scene.audio.rate / choice.divisor, choice.cost);
  }
  if (!file.flush()) {
    throw std::runtime_error(fmt::format("can't write {}", path.string()));
  }
}

void report_choices(const std::vector<proxies::Choice>& choices) {
  std::array<int, 4> counts{};
  for (const proxies::Choice& choice : choices) {
    ++counts[static_cast<std::size_t>(choice.kind)];
  }
  spdlog::info("{} proxies began to sound, {} became stable, {} were faded out for others", counts[0], counts[1],
               counts[2]);
  if (counts[3] > 0) {
    spdlog::warn("{} forces were left out: --most-active or --budget is too small for them", counts[3]);
  }
}

nlohmann::json proxy_facts(const scene::Scene& scene, const std::vector<proxy_bodies::ProxyBody>& bodies) {
  nlohmann::json facts = {{"deck", scene::resolved_deck(scene.deck, scene.overrides)}};
  for (const proxy_bodies::ProxyBody& body : bodies) {
    facts["bodies"][body.name] = {{"masses", body.lattice->masses().size()},
                                  {"springs", body.lattice->springs().size()},
                                  {"triangles", body.lattice->mesh().surface.size()}};
  }
  return facts;
}

void refuse_tunings(const score::Score& score) {
  for (const score::ScoreEvent& event : score.events) {
    if (std::holds_alternative<score::Tuning>(event.action)) {
      throw std::runtime_error("--output-folder can't tune a body; leave out the events of type tune, or use --output");
    }
  }
}

/// By the radiation model of the deck.
int write_result(const scene::Scene& deck, const score::Score& score, const std::vector<ProxyLevels>& levels,
                 std::vector<proxies::Force> forces, const ProxiesOptions& options) {
  refuse_tunings(score);
  const scene::Scene scene = score::as_scored(deck, score);
  if (!scene.obstacles.empty()) {
    spdlog::warn("obstacles do not reflect or hide the sound of proxies");
  }
  std::vector<proxy_bodies::ProxyBody> sounding;
  for (std::size_t body = 0; body < scene.bodies.size(); ++body) {
    sounding.push_back({scene.bodies[body].name, levels[body].front()});
  }
  const loop::OutputLock lock(options.result, scene.name, MPI_COMM_WORLD);
  proxy_bodies::ProxySource source(
      sounding, std::move(forces), scene,
      {.integrator = options.integrator, .significant_distance = options.significant_distance});
  parallel::Stages stages;
  const loop::JobEnding ending = loop::perform({.scene = scene,
                                                .source = source,
                                                .stages = stages,
                                                .folder = options.result,
                                                .sound_samples = bodies::sound_samples(scene),
                                                .facts = [&] { return proxy_facts(scene, sounding); }},
                                               MPI_COMM_WORLD);
  if (ending.status == loop::exit_finished) {
    spdlog::info("{:.4g} s of sound in {:.3g} s of processor time", scene.time.duration, ending.processor_time);
  } else {
    spdlog::info("the sound up to here is in the result");
  }
  return ending.status;
}

/// By the engine, to a file or to the audio device.
void let_sound(const scene::Scene& scene, const score::Score& score, const std::vector<ProxyLevels>& levels,
               std::vector<proxies::Force> forces, const ProxiesOptions& options) {
  proxies::Engine engine(engine_options(options, scene));
  add_bodies(scene, levels, ear_of_proxies(scene, score, 0.0), engine);
  for (const score::ScoreEvent& event : score.events) {
    if (const auto tuning = drivers::tuning_of(event, std::llround(event.time * scene.audio.rate))) {
      engine.add(*tuning);
    }
  }
  for (proxies::Force& force : forces) {
    engine.add(std::move(force));
  }
  options.output.empty() ? play_proxies(engine, score, names_of(scene), scene.audio.rate, options.live)
                         : write_proxies(scene, score, options, engine);
  const std::vector<proxies::Choice> choices = engine.take_choices();
  if (!options.report.empty()) {
    write_choices(options.report, choices, scene);
  }
  report_choices(choices);
}

int proxies(const ProxiesOptions& options) {
  check_proxies(options);
  const scene::Scene scene = bodies::read_deck(options.deck, options.overrides, MPI_COMM_WORLD);
  score::Score score;
  score.duration = scene.time.duration;
  if (!options.score.empty()) {
    score = score::read_score(options.score, names_of(scene), {});
  }
  proxy_bodies::warn_of_what_proxies_lack(scene);
  if (!score.notes.empty()) {
    spdlog::warn("the notes of the score are left out; proxies play its events");
  }
  const std::vector<ProxyLevels> levels = levels_of_all(scene, options.levels);
  std::vector<proxies::Force> forces = driving_forces(options, scene, score, levels);
  if (!options.result.empty()) {
    return write_result(scene, score, levels, std::move(forces), options);
  }
  let_sound(scene, score, levels, std::move(forces), options);
  return loop::exit_finished;
}

}  // namespace

Command proxies_command() {
  return make_command<ProxiesOptions>("proxies", "render bodies as mass-spring proxies with levels of detail",
                                      Ranks::one, declare, proxies);
}

}  // namespace idiophone::app
