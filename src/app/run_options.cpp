#include "command_line.hpp"

#include "command_options.hpp"

namespace idiophone::app {

void CommandLine::add_run_options() {
  add_deck_options(*run, run_options);
  add_output_options(*run, run_options);
  run->add_option(
      "--scene", run_options.scene,
      "a sonic scene, whose sounds are bound to the motion and become part of the result (docs/use/timbre.md)");
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
  check
      ->add_option("--latency", check_options.latency,
                   "s: of a message between two ranks, for --ranks (default: 2e-6, or 4e-7 if this machine has a "
                   "processor for each rank)")
      ->check(CLI::Range(0.0, 1.0));
  check->add_option("--bandwidth", check_options.bandwidth, "bytes/s: of a rank, for --ranks")
      ->check(CLI::Range(1.0, 1e15))
      ->capture_default_str();
  add_json_flag(*check, check_options);
}

void CommandLine::add_listen_options() {
  listen
      ->add_option("recording", listen_options.recording,
                   "NAME.h5 of a run with output: {surface_motion: true}, or a recording (docs/use/surface_motion.md)")
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

}  // namespace idiophone::app
