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
      step_field(program, "step_field"),
      node_rates_at_rest(program, "node_rates_at_rest"),
      slow_ways(program, "slow_ways"),
      slow_nodes(program, "slow_nodes"),
      cool_nodes(program, "cool_nodes"),
      advance_nodes(program, "advance_nodes"),
      forecast_nodes(program, "forecast_nodes"),
      change_velocities(program, "change_velocities"),
      add_sources(program, "add_sources"),
      gather(program, "gather"),
      scatter(program, "scatter") {}

}  // namespace idiophone::waves
