// `idiophone run`: from a deck to sound.

#include "accelerator_choice.hpp"
#include "command.hpp"
#include "idiophone/app/deck_run.hpp"

namespace idiophone::app {

namespace {

void declare(CLI::App& app, RunOptions& options) {
  add_deck(app, options.deck, options.overrides);
  add_output_folder(app, options.output, "folder of the results");
  add_progress(app, options.progress);
  app.add_option(
      "--scene", options.scene,
      "a sonic scene, whose sounds are bound to the motion and become part of the result (docs/use/timbre.md)");
  add_accelerator(app, options.accelerator, "computes finite elements and waves on a grid");
  const deck::Choices<Accelerated> parts{
      {{"all", Accelerated::all}, {"waves", Accelerated::waves}, {"elements", Accelerated::elements}}};
  add_choice(app, "--accelerate", options.accelerated, parts, "what the accelerator computes");
  app.get_option("--accelerate")->needs("--accelerator");
  app.add_flag("--resume", options.resume, "go on from the newest checkpoint in the output folder");
}

int run(const RunOptions& options) {
  return run_deck(options, MPI_COMM_WORLD);
}

}  // namespace

Command run_command() {
  return make_command<RunOptions>("run", "compute the sound of a deck", Ranks::any, declare, run);
}

}  // namespace idiophone::app
