#pragma once
// The option --accelerator: which device computes waves on a grid and finite elements.

#include <mpi.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "idiophone/foundation/accelerator/accelerator.hpp"
#include "idiophone/scene/radiation_section.hpp"

namespace idiophone::app {

/// --accelerator
/// @param wish  as accelerator::Accelerator takes it; stays empty if there is none
/// @param text  what it does
void add_accelerator(CLI::App& app, std::string& wish, const std::string& text);

/// What an accelerator shall compute.
struct AcceleratedWork {
  bool waves = false;
  bool elements = false;
};

[[nodiscard]] bool has_waves(const scene::Radiation& radiation);

/// Opens what is wished for, and says so. Where several devices fit, the ranks of a machine take them in turn.
/// Collective.
/// @return null if the wish is empty
/// @throws std::runtime_error, on all ranks, if no device fits, or there is no work for it
[[nodiscard]] std::unique_ptr<accelerator::Accelerator> open_accelerator(const std::string& wish,
                                                                         const AcceleratedWork& work,
                                                                         MPI_Comm communicator);

}  // namespace idiophone::app
