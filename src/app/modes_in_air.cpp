#include "modes_in_air.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "idiophone/air/harmonic/wet_modes.hpp"
#include "idiophone/foundation/parallel/broadcast.hpp"
#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/foundation/parallel/errors.hpp"

namespace idiophone::app {

namespace {

harmonic::DryModes dry_modes(const eigenmodes::Modes& found, const std::vector<std::vector<double>>& shapes,
                             const mesh::Mesh& mesh) {
  harmonic::DryModes dry{
      .nodes = mesh.nodes, .triangles = mesh.surface, .shapes = shapes, .frequencies = {}, .decays = {}};
  for (const eigenmodes::Mode& mode : found.modes) {
    dry.frequencies.push_back(mode.frequency);
    dry.decays.push_back(mode.damping_ratio * 2.0 * std::numbers::pi * mode.frequency);
  }
  return dry;
}

harmonic::QuietAir quiet(const scene::AirProperties& air) {
  return {.density = air.density, .speed = air.speed};
}

/// Rank 0's, on all ranks. Collective.
void share(std::vector<harmonic::WetMode>& modes, MPI_Comm communicator) {
  auto count = modes.size();
  parallel::broadcast(count, communicator);
  modes.resize(count);
  for (harmonic::WetMode& mode : modes) {
    for (double* number : {&mode.frequency, &mode.decay, &mode.radiation_decay}) {
      parallel::broadcast(*number, communicator);
    }
    parallel::broadcast(mode.shares, communicator);
  }
}

/// @param shapes  this rank's, of all dry modes
void replace(eigenmodes::Mode& mode, const harmonic::WetMode& wet, const std::vector<std::vector<double>>& shapes) {
  const double decay = wet.decay + wet.radiation_decay;
  mode.frequency = wet.frequency;
  mode.damping_ratio = decay / (2.0 * std::numbers::pi * wet.frequency);
  mode.decay_time = std::log(1000.0) / decay;
  mode.shape = harmonic::mixed(wet, shapes);
}

}  // namespace

AirOfModes take_air(eigenmodes::Modes& found, const std::vector<std::vector<double>>& shapes,
                    const std::vector<mesh::Mesh>& meshes, const scene::AirProperties& air, MPI_Comm communicator,
                    const PartWatch& watch) {
  std::vector<harmonic::WetMode> wet;
  parallel::on_root(communicator, [&] {
    const harmonic::DryModes dry = dry_modes(found, shapes, meshes.front());
    if (const std::size_t resolved = harmonic::resolved_modes(dry, air.speed); resolved < found.modes.size()) {
      spdlog::warn("{} of {} modes have no air: their sound has less than three edges of the mesh in a wavelength",
                   found.modes.size() - resolved, found.modes.size());
    }
    wet = harmonic::wet_modes(dry, quiet(air), watch);
  });
  share(wet, communicator);
  std::vector<std::vector<double>> own;
  std::ranges::transform(found.modes, std::back_inserter(own), &eigenmodes::Mode::shape);
  AirOfModes result{std::vector(found.modes.size(), std::numeric_limits<double>::quiet_NaN()),
                    std::vector(found.modes.size(), std::numeric_limits<double>::quiet_NaN())};
  for (std::size_t m = 0; m < wet.size(); ++m) {
    result.shift[m] = harmonic::cents(found.modes[m].frequency, wet[m].frequency);
    result.radiation_decay[m] = wet[m].radiation_decay;
    replace(found.modes[m], wet[m], own);
  }
  return result;
}

void warn_of_air(const eigenmodes::Modes& found, const std::vector<std::vector<double>>& shapes, const mesh::Mesh& mesh,
                 const scene::AirProperties& air) {
  const harmonic::DryModes dry = dry_modes(found, shapes, mesh);
  if (const auto [mode, shift] = harmonic::largest_estimated_shift(dry, quiet(air)); shift > harmonic::audible_shift) {
    spdlog::warn("the mass of the air would lower mode {} by about {:.0f} cents; --in-air takes it into account",
                 mode + 1, shift);
  }
}

}  // namespace idiophone::app
