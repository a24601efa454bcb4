#include "command_line.hpp"

#include "command_options.hpp"

namespace idiophone::app {

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
                   "resonances, a YAML file (docs/use/identify.md), or a recording: WAV, FLAC, ...")
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

}  // namespace idiophone::app
