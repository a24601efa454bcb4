#include "stage_options.hpp"

#include <cmath>
#include <string>

#include "idiophone/instruments/proxies/engine.hpp"
#include "shared_options.hpp"

namespace idiophone::app {

void add_stage(CLI::App& app, timbre::PlaySettings& settings) {
  app.add_option("--score", settings.score, "what is played and when, a YAML file (docs/use/play.md)");
  app.add_option("--contacts", settings.contacts, "NAME.h5 of a run: its contact forces strike the bodies");
  app.add_option("--motion", settings.motion, "NAME.h5 of a run, whose channels `motion` of the score follows");
  CLI::Option* osc = app.add_option("--osc", settings.osc, "UDP port for OSC messages")->check(CLI::Range(1, 65535));
  app.add_option("--osc-address", settings.osc_address,
                 "address of this machine for --osc; 0.0.0.0 opens the port to the network")
      ->needs(osc)
      ->capture_default_str();
  app.add_option("--midi", settings.midi, "a MIDI file, or jack: notes from JACK's MIDI");
  app.add_option("--midi-out", settings.midi_out,
                 "plays the notes on a MIDI input of JACK instead of the sound: part of its name, or jack: what is "
                 "connected");
  add_output_file(app, settings.output, "file to write instead of playing: .wav, or .h5 for a result");
  app.add_option("--device", settings.device, "part of the audio device's name, e.g. JACK (default: the system's)");
  app.add_option("--full-scale", settings.full_scale, "Pa: pressure of the device's loudest sample")
      ->check(CLI::Range(1e-9, 1e9))
      ->capture_default_str();
  app.add_option("--buffers", settings.buffers, "that proxies and trees are computed ahead")
      ->check(CLI::Range(2, 1000))
      ->capture_default_str();
}

namespace {

/// @param text  BODY=PA
void add_strength(const std::string& text, std::map<std::string, double>& strength) {
  const std::size_t place = text.rfind('=');
  double pascals = 0.0;
  if (place == std::string::npos || place == 0 || !CLI::detail::lexical_cast(text.substr(place + 1), pascals) ||
      !(pascals > 0.0) || !std::isfinite(pascals)) {
    throw CLI::ValidationError("--strength", text + " is not BODY=PA with a stress above 0, such as pane=6e7");
  }
  strength[text.substr(0, place)] = pascals;
}

}  // namespace

void add_springs(CLI::App& app, proxy_bodies::Springs& springs) {
  const deck::Choices<proxy_bodies::Springs> choices{
      {{"van_gelder", proxy_bodies::Springs::van_gelder}, {"fitted", proxy_bodies::Springs::fitted}}};
  add_choice(app, "--springs", springs, choices, "of proxies: by the material, or fitted to modes of finite elements");
}

void add_proxies(CLI::App& app, timbre::ProxySettings& settings) {
  proxies::EngineOptions& engine = settings.engine;
  app.add_option("--report", settings.report, "CSV file for the choices of the proxies' levels over time");
  add_springs(app, settings.springs);
  app.add_option("--levels", settings.levels,
                 "meshes of each proxy, each with elements twice as large as the one before")
      ->check(CLI::Range(1, 6))
      ->capture_default_str();
  app.add_option("--lowest-rate", engine.largest_divisor, "of a proxy: the audio rate over this power of two")
      ->check(CLI::IsMember({1, 2, 4, 8, 16}))
      ->capture_default_str();
  app.add_option("--most-active", engine.most_active, "proxies that may sound at once")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  app.add_option("--budget", settings.budget,
                 "processor time of sound maps and proxies per time of sound (default: any)")
      ->check(CLI::Range(1e-6, 1e6));
  app.add_option("--speed", settings.speed, "of the machine, for --budget: springs that one core computes in a second")
      ->check(CLI::Range(1e3, 1e12))
      ->capture_default_str();
  const deck::Choices<proxies::Priority> priorities{{{"distance", proxies::Priority::distance},
                                                     {"loudness", proxies::Priority::loudness},
                                                     {"order", proxies::Priority::fixed},
                                                     {"audibility", proxies::Priority::audibility}}};
  add_choice(app, "--priority", engine.priority, priorities, "who may sound, and in which detail");
  app.add_option("--behind", engine.behind, "times the priority of bodies behind a listener that looks somewhere")
      ->check(CLI::Range(1e-6, 1.0))
      ->capture_default_str();
  app.add_option_function<std::vector<std::string>>(
         "--strength",
         [&settings](const std::vector<std::string>& strengths) {
           for (const std::string& text : strengths) {
             add_strength(text, settings.strength);
           }
         },
         "BODY=PA: tensile stress above which a proxy breaks into pieces; any number")
      ->take_all()
      ->expected(1);
  app.add_option("--frames-per-second", settings.frames_per_second,
                 "of the motion of proxies, for films, in --output FILE.h5 (default: none)")
      ->check(CLI::Range(1e-3, 1e3));
  const deck::Choices<proxies::Integrator> integrators{{{"symplectic_euler", proxies::Integrator::symplectic_euler},
                                                        {"improved_euler", proxies::Integrator::improved_euler}}};
  add_choice(app, "--integrator", engine.integrator, integrators, "of the motion");
  const deck::Choices<proxies::Sound> sounds{
      {{"pressure", proxies::Sound::pressure}, {"deviation", proxies::Sound::deviation}}};
  add_choice(app, "--sound", engine.sound, sounds, "what is heard of a proxy");
  app.add_option("--significant-distance", engine.significant_distance, "m: masses that move less become stable")
      ->check(CLI::Range(1e-30, 1.0))
      ->capture_default_str();
}

}  // namespace idiophone::app
