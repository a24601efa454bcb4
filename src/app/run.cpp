#include "commands.hpp"
#include "idiophone/mesh/on_root.hpp"
#include "preparation.hpp"
#include "progress.hpp"
#include "simulation.hpp"
#include "stop.hpp"
#include "wav_files.hpp"

namespace idiophone::app {

int run(const RunOptions& options) {
  MPI_Comm communicator = MPI_COMM_WORLD;
  watch_signals();
  const Preparation ready = prepare(options.deck, options.overrides, communicator);
  mesh::on_root(communicator, [&] { std::filesystem::create_directories(options.output); });
  int status = exit_failed;
  {
    Simulation simulation(ready, options.output, options.resume, communicator);
    status = simulation.run(progress_line(options.progress));
  }
  if (status == exit_finished) {
    mesh::on_root(communicator, [&] { write_wavs(ready.scene, options.output); });
  }
  return status;
}

}  // namespace idiophone::app
