#include "coupled_air.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace idiophone::propagation {

namespace {

/// Of the air at the box, once in each step.
surface::Sampling sampling(const scene::Acoustics& acoustics, int steps) {
  return {.rate = acoustics.audio.rate,
          .steps_per_sample = steps,
          .max_frequency = acoustics.audio.max_frequency,
          .kernel_wavelengths = acoustics.audio.kernel_wavelengths,
          .impedance = acoustics.radiation.air.impedance()};
}

}  // namespace

CoupledAir::CoupledAir(const scene::Acoustics& acoustics, const propagation::AudibleSurface& surface,
                       std::int64_t steady, parallel::Stages& stages, MPI_Comm communicator,
                       accelerator::Accelerator* accelerator)
    : impedance_(acoustics.radiation.air.impedance()),
      stages_(stages),
      communicator_(communicator),
      grid_(acoustics, surface, communicator, accelerator),
      velocity_changes_(3 * grid_.moving()),
      pressure_changes_(3 * grid_.moving()),
      heard_(emission_at_rest()),
      pressure_(sampling(acoustics, grid_.plan().steps), surface::ReadTime::end, heard_.surface_pressure.size()),
      gradient_(sampling(acoustics, grid_.plan().steps), surface::ReadTime::end, heard_.pressure_gradient.size()),
      latency_(steady + sampling(acoustics, grid_.plan().steps).latency()),
      ears_(acoustics, steady + 1 - latency_, grid_.patches()) {}

surface::Emission CoupledAir::emission_at_rest() {
  grid_.begin_emission();
  return grid_.finish_emission();
}

void CoupledAir::start(std::int64_t /*sample*/, const surface::SurfaceMotion& steady) {
  grid_.start(steady);
  find_near();
}

void CoupledAir::connect(const std::vector<Index>& triangles) {
  exchange_.emplace(triangles, communicator_);
}

void CoupledAir::find_near() {
  if (exchange_) {
    exchange_->find_near(grid_.obstruction(), grid_.division());
  }
}

void CoupledAir::advance(std::span<const double> changes, std::span<double> force, std::span<double> resistance) {
  const parallel::Stages::Scope stage(stages_, parallel::Stage::radiation);
  if (step_ == 0) {
    move_surfaces();
  }
  if (grid_.failed()) {
    std::ranges::fill(force, 0.0);
    std::ranges::fill(resistance, 0.0);
    return;
  }
  step(changes);
  exchange_->return_forces(grid_.forces(), force, resistance);
  filter(step_++);
  std::ranges::transform(resistance, resistance.begin(), [this](double area) { return impedance_ * area; });
}

void CoupledAir::move_surfaces() {
  try {
    if (grid_.receive_positions()) {
      find_near();
    }
  } catch (const std::runtime_error& error) {
    problem_ = error.what();  // on all ranks alike
  }
}

void CoupledAir::step(std::span<const double> changes) {
  exchange_->send_velocities(changes, velocity_changes_);
  std::ranges::transform(velocity_changes_, pressure_changes_.begin(),
                         [this](double change) { return static_cast<float>(impedance_ * change); });
  grid_.step(pressure_changes_);
  grid_.begin_emission();
}

void CoupledAir::filter(int step) {
  const surface::Emission& now = grid_.finish_emission();
  for (std::size_t pack = 0; pack < heard_.surface_pressure.size() / pack_size; ++pack) {
    pressure_.add(pack, std::array{&now.surface_pressure[pack * pack_size]}, step);
    gradient_.add(pack, std::array{&now.pressure_gradient[pack * pack_size]}, step);
  }
}

void CoupledAir::propagate(std::int64_t sample, const surface::Emission& /*emission*/,
                           const surface::SurfaceMotion& motion) {
  const parallel::Stages::Scope stage(stages_, parallel::Stage::radiation);
  if (!problem_.empty()) {
    throw std::runtime_error(problem_);
  }
  step_ = 0;
  pressure_.take(heard_.surface_pressure);
  gradient_.take(heard_.pressure_gradient);
  grid_.send_positions(sample, motion);
  require_outside(ears_.positions(sample - latency_));
  ears_.hear(sample - latency_, heard_, nullptr);
}

void CoupledAir::require_outside(std::span<const Vector3> ears) const {
  for (const Vector3& place : ears) {
    if (grid_.plan().enclosure.contains(grid_.plan().grid.in_cells(place))) {
      throw std::runtime_error(
          "with radiation: {back: true}, a listener must not be inside the box around the bodies; move it away by "
          "three cells and radiation.margin, or more");
    }
  }
}

void CoupledAir::archive(parallel::Archive& archive) {
  move_surfaces();
  grid_.archive(archive);
  if (archive.restoring()) {
    find_near();
  }
  archive.rows("waves/box", grid_.patch_rows(), [this](std::size_t patch, parallel::ArchiveRow& row) {
    pressure_.archive(patch, row);
    gradient_.archive(patch, row);
  });
  ears_.archive(archive, grid_.patch_rows());
}

}  // namespace idiophone::propagation
