#pragma once
// The command line: all commands with their options.

#include <CLI/CLI.hpp>

#include "commands.hpp"

namespace idiophone::app {

/// Declares the commands; the chosen one is called after parsing.
struct CommandLine {
  CLI::App app{
      "From a deck and a mesh to the exact sound of a struck, plucked, dropped or bent solid object.\n"
      "Start `run`, `check`, `modes`, `map`, `radiate`, `listen` and `evolve` under mpirun to use several ranks. "
      "PETSc's options (-log_view, ...) come last."};
  RunOptions run_options;
  ListenOptions listen_options;
  CheckOptions check_options;
  InfoOptions info_options;
  AnalyzeOptions analyze_options;
  ModesOptions modes_options;
  MapOptions map_options;
  ExportOptions export_options;
  ExploreOptions explore_options;
  ReportOptions report_options;
  PlayOptions play_options;
  TimbreOptions timbre_options;
  EvolveOptions evolve_options;
  ProxiesOptions proxies_options;
  RadiateOptions radiate_options;
  IdentifyOptions identify_options;
  TuneOptions tune_options;
  CLI::App* run = app.add_subcommand("run", "compute the sound of a deck");
  CLI::App* check = app.add_subcommand("check", "validate and mesh a deck; print sizes, step, memory and time");
  CLI::App* modes = app.add_subcommand("modes", "find the eigenfrequencies and mode shapes of a body");
  CLI::App* map = app.add_subcommand("map", "make sound maps of bodies: all that the sound of a blow needs");
  CLI::App* to_export =
      app.add_subcommand("export", "write a sound map for Faust or as glTF, or a timbre tree for Faust");
  CLI::App* explore = app.add_subcommand("explore", "make a web page on which the bodies of sound maps are struck");
  CLI::App* report = app.add_subcommand("report", "make one web page about a run, or about two to compare");
  CLI::App* radiate = app.add_subcommand("radiate", "compute the sound of a body's modes by boundary elements");
  CLI::App* identify = app.add_subcommand("identify", "find a material's constants from measured resonances");
  CLI::App* tune = app.add_subcommand("tune", "find numbers of a deck that give its modes wanted frequencies");
  CLI::App* listen = app.add_subcommand("listen", "hear a recorded motion with other listeners or another model");
  CLI::App* play = app.add_subcommand("play", "play sound maps in real time, or write the sound to a file");
  CLI::App* timbre = app.add_subcommand("timbre", "make the sounds and the music of a sonic scene, bound to motion");
  CLI::App* evolve = app.add_subcommand("evolve", "breed timbre trees, by ear or towards a sound");
  CLI::App* proxies = app.add_subcommand("proxies", "render bodies as mass-spring proxies with levels of detail");
  CLI::App* info = app.add_subcommand(
      "info", "tell what is in a result, a recording, a checkpoint, a sound map or a file of `radiate`");
  CLI::App* analyze = app.add_subcommand("analyze", "find the partials of a sound");

  CommandLine();

  /// Whether standard output is for an answer in JSON or YAML alone; what is logged then goes to standard error.
  [[nodiscard]] bool answers_scripts() const;

  /// Calls the command that was parsed. @return exit status
  [[nodiscard]] int call() const;

 private:
  void add_run_options();
  void add_check_options();
  void add_listen_options();
  void add_modes_options();
  void add_map_options();
  void add_export_options();
  void add_play_options();
  void add_timbre_options();
  void add_evolve_options();
  void add_proxies_options();
  void add_radiate_options();
  void add_identify_options();
  void add_tune_options();
  /// Of report, info and analyze, which read results.
  void add_report_options();
};

}  // namespace idiophone::app
