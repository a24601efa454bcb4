#include "command_line.hpp"

#include <algorithm>
#include <array>
#include <functional>

namespace idiophone::app {

namespace {

void add_overrides(CLI::App& command, std::vector<std::string>& overrides) {
  command.add_option("--set", overrides, "KEY.PATH=VALUE: overrides a value of the deck; may be given again")
      ->take_all()
      ->expected(1);
}

/// @param options  with a deck and overrides
template <class Options>
void add_deck_options(CLI::App& command, Options& options) {
  command.add_option("deck", options.deck, "the scene, a YAML file (docs/deck.md)")->required();
  add_overrides(command, options.overrides);
}

/// @param options  with a directory and a way to tell progress
template <class Options>
void add_output_options(CLI::App& command, Options& options) {
  command.add_option("--output", options.output, "directory of the results")->capture_default_str();
  command.add_option("--progress", options.progress, "one updating line, or lines of a log (under mpirun: log)")
      ->check(CLI::IsMember({"auto", "line", "log"}))
      ->capture_default_str();
}

/// @param options  of a command that answers people or scripts
template <class Options>
void add_json_flag(CLI::App& command, Options& options) {
  command.add_flag_callback(
      "--json", [&options] { options.style = Style::json; }, "answer in JSON, for scripts");
}

}  // namespace

CommandLine::CommandLine() {
  app.set_version_flag("--version", IDIOPHONE_VERSION);
  app.require_subcommand(1);
  add_run_options();
  add_check_options();
  add_listen_options();
  add_modes_options();
  add_map_options();
  add_export_options();
  add_play_options();
  add_timbre_options();
  add_evolve_options();
  add_proxies_options();
  add_radiate_options();
  add_identify_options();
  add_tune_options();
  add_report_options();
}

void CommandLine::add_run_options() {
  add_deck_options(*run, run_options);
  add_output_options(*run, run_options);
  run->add_option("--scene", run_options.scene,
                  "a sonic scene, whose sounds are bound to the motion and become part of the result (docs/timbre.md)");
  run->add_flag("--resume", run_options.resume, "go on from the newest checkpoint in the output directory");
}

void CommandLine::add_check_options() {
  add_deck_options(*check, check_options);
  check->add_option("--output", check_options.output, "directory of the results, whose free space is compared")
      ->capture_default_str();
  check->add_flag("--resolved", check_options.resolved,
                  "print the deck with overrides and defaults, itself a deck, and do nothing else");
  check
      ->add_option("--accuracy", check_options.accuracy,
                   "cents: recommend the cheapest mesh with this accuracy of pitch (default with --up-to: 5)")
      ->check(CLI::Range(0.1, 100.0));
  check->add_option("--up-to", check_options.up_to, "Hz: up to this frequency (default with --accuracy: 5000)")
      ->check(CLI::Range(1.0, 1e5));
  check
      ->add_option("-n,--ranks", check_options.ranks,
                   "predict sizes, memory and speed-up of a run on so many ranks; start without mpirun")
      ->check(CLI::Range(1, 1 << 20));
  check->add_option("--latency", check_options.network.latency, "s: of a message between two ranks, for --ranks")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  check->add_option("--bandwidth", check_options.network.bandwidth, "bytes/s: of a rank, for --ranks")
      ->check(CLI::Range(1.0, 1e15))
      ->capture_default_str();
  add_json_flag(*check, check_options);
}

void CommandLine::add_listen_options() {
  listen
      ->add_option("recording", listen_options.recording,
                   "NAME.h5 of a run with output: {surface_motion: true}, or a recording (docs/surface_motion.md)")
      ->required();
  listen->add_option("deck", listen_options.deck, "other listeners, a YAML file (default: the run's own deck)");
  add_overrides(*listen, listen_options.overrides);
  add_output_options(*listen, listen_options);
}

void CommandLine::add_report_options() {
  report->add_option("results", report_options.results, "NAME.h5, or two to compare")->required()->expected(1, 2);
  report->add_option("-o,--output", report_options.page, "the page to write")->capture_default_str();
  info->add_option("file", info_options.file, "NAME.h5, a recording, a checkpoint, a sound map or NAME_radiation.h5")
      ->required();
  info->add_option("--channel", info_options.channel,
                   "print the rows of this channel of a result as CSV, e.g. motion/plate/velocity or energy");
  info->add_flag("--verify", info_options.verify,
                 "read all of it, compare it with its checksums, and name what is damaged; status 1 if anything is");
  add_json_flag(*info, info_options);
  analyze->add_option("result", analyze_options.result, "NAME.h5, or a sound file: WAV, FLAC, ...")->required();
  analyze->add_option("--listener", analyze_options.listener, "only this one");
  analyze
      ->add_option("--start", analyze_options.start,
                   "s, after the blow; levels are those at this time (default: 0.02, or a tenth of a short sound)")
      ->capture_default_str();
  analyze->add_option("--duration", analyze_options.duration, "s to look at");
  analyze->add_option("--lowest", analyze_options.lowest, "Hz")->capture_default_str();
  analyze->add_option("--highest", analyze_options.highest, "Hz");
  analyze->add_option("--range", analyze_options.dynamic_range, "dB below the strongest partial")
      ->capture_default_str();
  analyze->add_option("--tolerance", analyze_options.tolerance, "cents, of matches with the deck's references")
      ->capture_default_str();
  add_json_flag(*analyze, analyze_options);
  analyze->add_option("--partials", analyze_options.partials, "CSV file for the partials");
  analyze->add_option("--spectrum", analyze_options.spectrum, "CSV file for the spectrum");
  analyze->add_option("--spectrogram", analyze_options.spectrogram, "CSV file for the spectrogram");
}

void CommandLine::add_modes_options() {
  add_deck_options(*modes, modes_options);
  modes->add_option("--body", modes_options.body, "of the deck (default: the first)");
  modes->add_option("--count", modes_options.count, "of modes, the lowest")->capture_default_str();
  modes->add_option("--mass", modes_options.mass, "lumped, as the motion has it, or consistent")
      ->check(CLI::IsMember({"lumped", "consistent"}))
      ->capture_default_str();
  modes->add_option("--shift", modes_options.shift,
                    "Hz below zero from where the search begins (default: from the body's size)");
  modes->add_option("--references", modes_options.references, "Hz,Hz,...: to compare with (default: the deck's)")
      ->delimiter(',')
      ->allow_extra_args(false);
  modes->add_option("--tolerance", modes_options.tolerance, "cents, of matches with references")->capture_default_str();
  modes->add_option("--output", modes_options.output, "directory of the results")->capture_default_str();
  add_json_flag(*modes, modes_options);
}

void CommandLine::add_map_options() {
  add_deck_options(*map, map_options);
  CLI::Option* up_to =
      map->add_option("--up-to", map_options.up_to, "Hz: all modes up to there")->check(CLI::Range(1.0, 1e6));
  up_to->capture_default_str();
  map->add_option("--count", map_options.count, "of modes, the lowest, instead of --up-to")
      ->check(CLI::Range(1, 1000000))
      ->excludes(up_to);
  map->add_option("--radiation", map_options.radiation,
                  "boundary_elements or kirchhoff (default: boundary elements if they take less than two minutes)")
      ->check(CLI::IsMember({"boundary_elements", "kirchhoff"}));
  map->add_option("--output", map_options.output, "directory of the maps")->capture_default_str();
}

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
  play->add_option("--score", play_options.score, "what is played and when, a YAML file (docs/play.md)");
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
  timbre->add_option("scene", timbre_options.scene, "the sonic scene, a YAML file (docs/timbre.md)")->required();
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
  proxies->add_option("--score", proxies_options.score, "what is done to the bodies, a YAML file (docs/play.md)");
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

void CommandLine::add_radiate_options() {
  add_deck_options(*radiate, radiate_options);
  radiate->add_option("--body", radiate_options.body, "of the deck (default: the first)");
  CLI::Option* modes_count =
      radiate->add_option("--modes", radiate_options.modes, "number of modes, the lowest")->capture_default_str();
  radiate
      ->add_option("--frequencies", radiate_options.frequencies,
                   "Hz,Hz,...: of rigid motions along x, y and z with 1 m/s, instead of modes")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->excludes(modes_count);
  radiate->add_option("--waves", radiate_options.cell, "m: compare with model waves, too, with cells of this size");
  radiate->add_option("--output", radiate_options.output, "directory of the results")->capture_default_str();
  add_json_flag(*radiate, radiate_options);
}

void CommandLine::add_identify_options() {
  add_deck_options(*identify, identify_options);
  identify
      ->add_option("--measured", identify_options.measured,
                   "resonances, a YAML file (docs/identify.md), or a recording: WAV, FLAC, ...")
      ->required();
  identify->add_option("--body", identify_options.body, "of the deck (default: the first)");
  identify
      ->add_option("--fit", identify_options.constants,
                   "elastic constants to fit, e.g. young,poisson (default: all of the material)")
      ->delimiter(',')
      ->allow_extra_args(false);
  identify->add_option("--tolerance", identify_options.tolerance, "cents between a line and its mode")
      ->capture_default_str();
  identify->add_option("--lines", identify_options.lines, "fit only so many lines, the lowest, and predict the others")
      ->check(CLI::Range(1, 1000000));
  identify->add_option("--mass", identify_options.mass, "consistent, or lumped, as the motion has it")
      ->check(CLI::IsMember({"lumped", "consistent"}))
      ->capture_default_str();
  add_json_flag(*identify, identify_options);
}

void CommandLine::add_tune_options() {
  add_deck_options(*tune, tune_options);
  tune->add_option("--target", tune_options.target, "frequencies or notes, e.g. 187,F#5, or ratios, e.g. 1:4:10")
      ->required();
  tune->add_option("--pitch", tune_options.pitch, "note or Hz of the first of the ratios (default: any)");
  tune->add_option("--vary", tune_options.vary,
                   "KEY=LOWEST:HIGHEST: number of the deck that may be changed; may be given again")
      ->required()
      ->take_all()
      ->expected(1);
  tune->add_option("--modes", tune_options.modes, "numbers of the modes at the start (default: the lowest)")
      ->delimiter(',')
      ->allow_extra_args(false);
  tune->add_option("--body", tune_options.body, "of the deck (default: the first)");
  tune->add_option("--tolerance", tune_options.tolerance, "cents")->capture_default_str();
  tune->add_option("--a4", tune_options.a4, "Hz, of the note A4")->capture_default_str();
  tune->add_option("--mass", tune_options.mass, "lumped, as the motion has it, or consistent")
      ->check(CLI::IsMember({"lumped", "consistent"}))
      ->capture_default_str();
  tune->add_option("-o,--output", tune_options.output, "the tuned deck to write");
  add_json_flag(*tune, tune_options);
}

bool CommandLine::answers_scripts() const {
  return check_options.resolved || check_options.style == Style::json || modes_options.style == Style::json ||
         radiate_options.style == Style::json || analyze_options.style == Style::json ||
         identify_options.style == Style::json || tune_options.style == Style::json;
}

int CommandLine::call() const {
  struct Command {
    const CLI::App* name;
    std::function<int()> call;
  };
  const std::array commands = {
      Command{run, [this] { return app::run(run_options); }},
      Command{check, [this] { return app::check(check_options); }},
      Command{modes, [this] { return app::modes(modes_options); }},
      Command{map, [this] { return app::map(map_options); }},
      Command{to_export, [this] { return app::export_map(export_options); }},
      Command{explore, [this] { return app::explore(explore_options); }},
      Command{report, [this] { return app::report(report_options); }},
      Command{radiate, [this] { return app::radiate(radiate_options); }},
      Command{identify, [this] { return app::identify(identify_options); }},
      Command{tune, [this] { return app::tune(tune_options); }},
      Command{listen, [this] { return app::listen(listen_options); }},
      Command{play, [this] { return app::play(play_options); }},
      Command{timbre, [this] { return app::timbre(timbre_options); }},
      Command{evolve, [this] { return app::evolve(evolve_options); }},
      Command{proxies, [this] { return app::proxies(proxies_options); }},
      Command{info, [this] { return app::info(info_options); }},
      Command{analyze, [this] { return app::analyze(analyze_options); }},
  };
  return std::ranges::find_if(commands, &CLI::App::parsed, &Command::name)->call();
}

}  // namespace idiophone::app
