#include "accelerator_choice.hpp"

#include <spdlog/spdlog.h>

#include <stdexcept>

#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/foundation/parallel/errors.hpp"

namespace idiophone::app {

void add_accelerator(CLI::App& app, std::string& wish) {
  app.add_option("--accelerator", wish,
                 "computes waves on a grid: gpu, the number of an OpenCL device, or part of its name (default: the "
                 "processor does)");
}

std::unique_ptr<accelerator::Accelerator> open_accelerator(const std::string& wish, const scene::Radiation& radiation,
                                                           MPI_Comm communicator) {
  if (wish.empty()) {
    return nullptr;
  }
  std::unique_ptr<accelerator::Accelerator> opened;
  const int rank = parallel::rank_of(parallel::RanksOfMachine(communicator).get());
  parallel::collectively(communicator, [&] {
    if (radiation.model != scene::RadiationModel::waves) {
      throw std::runtime_error(
          "--accelerator computes waves on a grid only; leave it out, or choose radiation: {model: waves, cell: ...}");
    }
    opened = std::make_unique<accelerator::Accelerator>(wish, rank);
  });
  if (parallel::is_root(communicator)) {
    spdlog::info("waves are computed by {}", opened->name());
  }
  return opened;
}

}  // namespace idiophone::app
