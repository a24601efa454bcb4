#include "command_line.hpp"

#include "command_options.hpp"

namespace idiophone::app {

void CommandLine::add_export_options() {
  to_export->add_option("map", export_options.map, "NAME_BODY.map.h5, of `map`, or a timbre tree, TREE.tt")->required();
  to_export->add_option("--faust", export_options.faust, "FILE.dsp: a program in Faust, from force to pressure");
  to_export->add_option("--at", export_options.at, "X,Y,Z: struck there in Faust, m (default: the first vertex)")
      ->delimiter(',')
      ->expected(3);
  to_export->add_option("--direction", export_options.direction, "X,Y,Z of the force in Faust (default: 0,0,-1)")
      ->delimiter(',')
      ->expected(3);
  to_export->add_option("--listener", export_options.listener, "who hears it in Faust (default: the first)");
  to_export->add_option("--gltf", export_options.gltf, "FILE.gltf with the extension KHR_audio_rigid_bodies");
  explore->add_option("maps", explore_options.maps, "NAME_BODY.map.h5 ..., of one `map`")->required();
  explore->add_option("-o,--output", explore_options.page, "the page to write")->capture_default_str();
  explore->add_option("--proxies", explore_options.proxies, "deck of the maps: its bodies also sound as proxies");
  explore->add_option("--levels", explore_options.levels, "of detail of the proxies")
      ->check(CLI::Range(1, 6))
      ->capture_default_str();
  add_overrides(*explore, explore_options.overrides);
}

void CommandLine::add_play_options() {
  play->add_option("maps", play_options.maps, "sound maps")->required();
  play->add_option("--score", play_options.score, "what is played and when, a YAML file (docs/use/play.md)");
  add_overrides(*play, play_options.overrides);
  play->add_option("--osc", play_options.osc, "UDP port for OSC messages")->check(CLI::Range(1, 65535));
  play->add_option("--midi", play_options.midi, "a MIDI file, or jack: notes from JACK's MIDI");
  play->add_option("--output", play_options.output, "WAV file to write instead of playing");
  play->add_option("--device", play_options.device,
                   "part of the audio device's name, e.g. JACK (default: the system's)");
  play->add_option("--rate", play_options.rate, "audio samples per second")
      ->check(CLI::Range(8000, 192000))
      ->capture_default_str();
  play->add_option("--frames", play_options.frames, "audio samples that the device asks for at once")
      ->check(CLI::Range(16, 8192))
      ->capture_default_str();
  play->add_option("--full-scale", play_options.full_scale, "Pa: pressure of the device's loudest sample")
      ->check(CLI::Range(1e-9, 1e9))
      ->capture_default_str();
}

void CommandLine::add_timbre_options() {
  timbre->add_option("scene", timbre_options.scene, "the sonic scene, a YAML file (docs/use/timbre.md)")->required();
  timbre->add_option("result", timbre_options.result, "NAME.h5 of a run, whose motion the sounds are bound to");
  add_overrides(*timbre, timbre_options.overrides);
  timbre->add_option("-o,--output", timbre_options.output, "WAV file to write (default: NAME.wav of the scene)");
}

void CommandLine::add_evolve_options() {
  evolve->add_option("trees", evolve_options.trees, "timbre trees that the others descend from")->required();
  CLI::Option* target =
      evolve->add_option("--target", evolve_options.target, "sound file with one channel that is to be imitated");
  evolve->add_option("-o,--output", evolve_options.output, "the tree to write, with a target")->capture_default_str();
  evolve->add_option("--page", evolve_options.page, "web page to write, on which trees are selected by ear")
      ->excludes(target);
  evolve->add_option("--duration", evolve_options.duration, "s: of a sound on the page")
      ->check(CLI::Range(0.1, 60.0))
      ->capture_default_str();
  evolve->add_flag("--constants", evolve_options.constants, "change numbers only, not the nodes");
  evolve->add_option("--population", evolve_options.population, "trees of a generation")
      ->check(CLI::Range(2, 10000))
      ->capture_default_str();
  evolve->add_option("--generations", evolve_options.generations, "with a target")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  evolve->add_option("--nodes", evolve_options.nodes, "numbers, names and lists of a tree, at most")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str();
  evolve->add_option("--seed", evolve_options.seed, "of all chance")->capture_default_str();
}

void CommandLine::add_proxies_options() {
  add_deck_options(*proxies, proxies_options);
  proxies->add_option("--score", proxies_options.score, "what is done to the bodies, a YAML file (docs/use/play.md)");
  proxies->add_option("--contacts", proxies_options.contacts,
                      "NAME.h5 of a run of the deck: its contact forces drive the proxies");
  proxies->add_option("--output", proxies_options.output, "WAV file to write instead of playing");
  proxies->add_option("--result", proxies_options.result,
                      "folder for NAME.h5 and its WAV files: the sound by the radiation model of the deck");
  proxies->add_option("--osc", proxies_options.osc, "UDP port for OSC messages")->check(CLI::Range(1, 65535));
  proxies->add_option("--device", proxies_options.device, "part of the audio device's name (default: the system's)");
  proxies->add_option("--frames", proxies_options.frames, "audio samples in a buffer")
      ->check(CLI::Range(16, 8192))
      ->capture_default_str();
  proxies->add_option("--buffers", proxies_options.buffers, "that are computed ahead")
      ->check(CLI::Range(2, 1000))
      ->capture_default_str();
  proxies->add_option("--full-scale", proxies_options.full_scale, "Pa: pressure of the device's loudest sample")
      ->check(CLI::Range(1e-9, 1e9))
      ->capture_default_str();
  proxies->add_option("--report", proxies_options.report, "CSV file for the choices of levels over time");
  proxies
      ->add_option("--levels", proxies_options.levels,
                   "meshes of each body, each with elements twice as large as the one before")
      ->check(CLI::Range(1, 6))
      ->capture_default_str();
  proxies->add_option("--lowest-rate", proxies_options.lowest_rate, "of a body: the audio rate over this power of two")
      ->check(CLI::IsMember({1, 2, 4, 8, 16}))
      ->capture_default_str();
  proxies->add_option("--most-active", proxies_options.most_active, "proxies that may sound at once")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  proxies->add_option("--budget", proxies_options.budget, "processor time per time of sound (default: any)")
      ->check(CLI::Range(1e-6, 1e6));
  proxies->add_option("--speed", proxies_options.speed, "springs that one core computes in a second, for --budget")
      ->check(CLI::Range(1e3, 1e12))
      ->capture_default_str();
  proxies->add_option("--priority", proxies_options.priority, "who may sound, and in which detail")
      ->check(CLI::IsMember({"distance", "loudness", "order"}))
      ->capture_default_str();
  proxies->add_option("--integrator", proxies_options.integrator, "of the motion")
      ->check(CLI::IsMember({"symplectic_euler", "improved_euler"}))
      ->capture_default_str();
  proxies->add_option("--sound", proxies_options.sound, "what is heard of a proxy")
      ->check(CLI::IsMember({"pressure", "deviation"}))
      ->capture_default_str();
  proxies
      ->add_option("--significant-distance", proxies_options.significant_distance,
                   "m: masses that move less become stable")
      ->check(CLI::Range(1e-30, 1.0))
      ->capture_default_str();
}

}  // namespace idiophone::app
