#include "commands.hpp"
#include "idiophone/parallel/on_root.hpp"
#include "idiophone/source/preparation.hpp"
#include "progress.hpp"
#include "read_deck.hpp"
#include "simulation.hpp"
#include "stop.hpp"
#include "wav_files.hpp"

namespace idiophone::app {

int run(const RunOptions& options) {
  MPI_Comm communicator = MPI_COMM_WORLD;
  watch_signals();
  const source::Preparation ready =
      source::prepare(read_deck(options.deck, options.overrides, communicator), communicator);
  parallel::on_root(communicator, [&] { std::filesystem::create_directories(options.output); });
  int status = exit_failed;
  {
    Simulation simulation(ready, options.output, options.resume, communicator);
    status = simulation.run(progress_line(options.progress));
  }
  if (status == exit_finished) {
    parallel::on_root(communicator, [&] { write_wavs(ready.scene, options.output); });
  }
  return status;
}

}  // namespace idiophone::app
