#include "wave_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "all_triangles.hpp"
#include "idiophone/air/propagation/wave_plan.hpp"
#include "idiophone/foundation/parallel/communicator.hpp"

namespace idiophone::propagation {

namespace {

/// How often the grid takes notice of motion.
constexpr int grid_updates_per_second = 1000;

/// Surfaces that have moved less than this, in cells, stay where they are on the grid: a quarter of a sub-voxel.
constexpr double least_motion = 1.0 / 32.0;

std::optional<waves::LossyAir> lossy_air(const scene::Radiation& radiation) {
  const scene::AirProperties& air = radiation.air;
  return radiation.grid.wall_losses ? std::optional(waves::lossy_air(air.speed, air.density, air.temperature))
                                    : std::nullopt;
}

}  // namespace

WaveGrid::WaveGrid(const scene::Acoustics& acoustics, const propagation::AudibleSurface& surface, MPI_Comm communicator,
                   accelerator::Accelerator* accelerator)
    : update_interval_(std::max(1, acoustics.audio.rate / grid_updates_per_second)),
      plan_(wave_plan(acoustics, surface, communicator)),
      triangles_(all_triangles(surface, communicator)),
      moving_(triangles_.size()),
      feels_air_(acoustics.radiation.grid.back),
      shared_positions_(surface.vertex_ids, communicator),
      division_(plan_.grid, parallel::size_of(communicator)),
      field_(division_, plan_.courant, communicator, lossy_air(acoustics.radiation), accelerator),
      box_(field_, plan_.enclosure),
      patch_rows_(box_.numbers(), box_.global_patches(), communicator) {
  arrived_.resize(3 * shared_positions_.vertices());
  positions_ = arrived_;
  for (const auto& triangle : surface.obstacles) {
    const auto vertex = static_cast<Index>(positions_.size() / 3);
    triangles_.push_back({vertex, vertex + 1, vertex + 2});
    for (const Vector3& corner : triangle) {
      positions_.insert(positions_.end(), corner.begin(), corner.end());
    }
  }
}

void WaveGrid::start(const surface::SurfaceMotion& steady) {
  shared_positions_.begin(steady.position);
  shared_positions_.finish(arrived_);
  require_within_reach(arrived_);
  std::ranges::copy(arrived_, positions_.begin());
  set_surfaces();
}

void WaveGrid::send_positions(std::int64_t sample, const surface::SurfaceMotion& motion) {
  if (sample % update_interval_ == 0) {
    shared_positions_.begin(motion.position);
    sending_ = true;
  }
}

bool WaveGrid::receive_positions() {
  if (!sending_) {
    return false;
  }
  sending_ = false;
  shared_positions_.finish(arrived_);
  if (!have_moved(arrived_)) {
    return false;
  }
  require_within_reach(arrived_);
  std::ranges::copy(arrived_, positions_.begin());
  set_surfaces();
  return true;
}

bool WaveGrid::have_moved(std::span<const float> positions) const {
  const auto limit = static_cast<float>(least_motion * plan_.grid.cell);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    if (!(std::abs(positions[i] - positions_[i]) <= limit)) {
      return true;
    }
  }
  return false;
}

void WaveGrid::require_within_reach(std::span<const float> positions) {
  const waves::Enclosure reach = plan_.reach();
  for (std::size_t i = 0; i < positions.size(); i += 3) {
    const Vector3 place(positions[i], positions[i + 1], positions[i + 2]);
    if (!reach.contains(plan_.grid.in_cells(place))) {
      failed_ = true;
      throw std::runtime_error(
          fmt::format("a body leaves the grid of the waves at ({:.4g}, {:.4g}, {:.4g}) m; give it more room by "
                      "radiation: {{margin: ...}}",
                      place[0], place[1], place[2]));
    }
  }
}

void WaveGrid::set_surfaces() {
  waves::CutCells cut_cells(field_.subdomain(), obstruction(), plan_.courant, field_.is_lossy());
  if (feels_air_) {
    coupling_ = waves::SurfaceCoupling(field_.subdomain(), obstruction(), moving_, cut_cells, plan_.courant);
  } else {
    sources_ = waves::SurfaceSources(field_.subdomain(), obstruction(), moving_, cut_cells, plan_.courant);
  }
  of_nodes_.resize(cut_cells.nodes().size());
  field_.set_surfaces(std::move(cut_cells));
}

void WaveGrid::step(std::span<const float> changes) {
  coupling_.add(changes, of_nodes_);
  field_.step(of_nodes_);
}

const std::vector<waves::ForceShare>& WaveGrid::forces() {
  field_.forecast(of_nodes_);
  return coupling_.forces(of_nodes_);
}

void WaveGrid::archive(parallel::Archive& archive) {
  receive_positions();
  std::vector<double> positions(positions_.begin(), positions_.end());
  archive.root("waves/positions", positions);
  if (archive.restoring()) {
    positions_.assign(positions.begin(), positions.end());
    set_surfaces();
  }
  field_.archive(archive);
}

}  // namespace idiophone::propagation
