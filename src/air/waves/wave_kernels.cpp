#include "wave_kernels.hpp"

#include <fmt/format.h>

#include "half_derivative.hpp"
#include "waves_kernel_files.hpp"

namespace idiophone::waves {

namespace {

std::string source() {
  std::string text = fmt::format("#define RELAXATIONS {}\n", HalfDerivative::terms);
  for (const std::string_view file : kernel_files) {
    text += file;
  }
  return text;
}

}  // namespace

WaveKernels::WaveKernels(accelerator::Accelerator& accelerator)
    : program(accelerator, source()),
      stretch_faces(program, "stretch_faces"),
      step_cells(program, "step_cells"),
      add_node_rates(program, "add_node_rates"),
      slow_ways(program, "slow_ways"),
      slow_nodes(program, "slow_nodes"),
      cool_nodes(program, "cool_nodes"),
      advance_nodes(program, "advance_nodes"),
      publish_nodes(program, "publish_nodes"),
      gather(program, "gather"),
      scatter(program, "scatter") {}

}  // namespace idiophone::waves
