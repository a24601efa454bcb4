#include "accelerator_choice.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <stdexcept>

#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/foundation/parallel/errors.hpp"

namespace idiophone::app {

void add_accelerator(CLI::App& app, std::string& wish, const std::string& text) {
  app.add_option("--accelerator", wish,
                 text + ": gpu, the number of an OpenCL device, or part of its name (default: the processor does)");
}

bool has_waves(const scene::Radiation& radiation) {
  return radiation.model == scene::RadiationModel::waves;
}

std::unique_ptr<accelerator::Accelerator> open_accelerator(const std::string& wish, const AcceleratedWork& work,
                                                           MPI_Comm communicator) {
  if (wish.empty()) {
    return nullptr;
  }
  std::unique_ptr<accelerator::Accelerator> opened;
  const int rank = parallel::rank_of(parallel::RanksOfMachine(communicator).get());
  parallel::collectively(communicator, [&] {
    if (!work.waves && !work.elements) {
      throw std::runtime_error(
          "--accelerator has nothing to compute: it takes waves on a grid (radiation: {model: waves, cell: ...}), and "
          "in a run bodies of finite elements; leave it out, or choose another --accelerate");
    }
    opened = std::make_unique<accelerator::Accelerator>(wish, rank);
    if (work.elements && !opened->has_doubles()) {
      throw std::runtime_error(
          fmt::format("{} has no double precision, which finite elements need; choose another device, or --accelerate "
                      "waves",
                      opened->name()));
    }
  });
  if (parallel::is_root(communicator)) {
    spdlog::info("{}{}{} are computed by {}", work.elements ? "finite elements" : "",
                 work.elements && work.waves ? " and " : "", work.waves ? "waves" : "", opened->name());
  }
  return opened;
}

}  // namespace idiophone::app
