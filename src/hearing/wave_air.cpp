#include "wave_air.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "all_triangles.hpp"
#include "idiophone/hearing/wave_plan.hpp"
#include "idiophone/parallel/communicator.hpp"

namespace idiophone::hearing {

namespace {

/// How often the grid takes notice of motion.
constexpr int grid_updates_per_second = 1000;

/// Surfaces that have moved less than this, in cells, stay where they are on the grid: a quarter of a sub-voxel.
constexpr double least_motion = 1.0 / 32.0;

}  // namespace

WaveAir::WaveAir(const scene::Scene& scene, const source::AudibleSurface& surface, std::int64_t steady,
                 parallel::Stages& stages, MPI_Comm communicator)
    : scene_(scene),
      stages_(stages),
      communicator_(communicator),
      plan_(wave_plan(scene, surface, communicator)),
      triangles_(all_triangles(surface, communicator)),
      moving_(triangles_.size()),
      triangle_ids_(parallel::gather_all(std::span<const Index>(surface.triangle_ids), communicator)),
      shared_positions_(surface.vertex_ids, communicator),
      shared_pressures_(triangle_ids_.counts, communicator),
      history_(moving_, plan_.steps),
      field_(waves::Slab::of_rank(plan_.grid, parallel::rank_of(communicator), parallel::size_of(communicator)),
             plan_.courant, communicator),
      changes_(moving_),
      box_(field_.slab(), plan_.enclosure),
      box_rows_(box_.numbers(), box_.global_patches(), communicator),
      ears_(scene, steady + 1 - latency(), box_.patches()) {
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

void WaveAir::start(std::int64_t /*sample*/, const surface::SurfaceMotion& steady) {
  shared_positions_.begin(steady.position);
  shared_positions_.finish(arrived_);
  require_within_reach(arrived_);
  std::ranges::copy(arrived_, positions_.begin());
  set_surfaces();
  const bool blocked = scene_.audio.dc_loss > 0.0;  // what has lasted for ever is not heard
  shared_pressures_.begin(own_pressures(blocked ? std::vector<double>(moving_) : steady.pressure));
  history_.fill(in_global_order(shared_pressures_.finish()));
}

void WaveAir::propagate(std::int64_t sample, const surface::Emission& emission, const surface::SurfaceMotion& motion) {
  const parallel::Stages::Scope stage(stages_, parallel::Stage::radiation);
  if (failed_) {
    return;
  }
  receive();
  send(sample, emission, motion);
  advance();
  ears_.hear(sample - latency(), box_.emission(field_), nullptr,
             [this](const Vector3& place) { return sounds_at(place); });
}

void WaveAir::send(std::int64_t sample, const surface::Emission& emission, const surface::SurfaceMotion& motion) {
  shared_pressures_.begin(own_pressures(emission.pressure));
  sending_ = true;
  if (sample % std::max(1, scene_.audio.rate / grid_updates_per_second) == 0) {
    shared_positions_.begin(motion.position);
    sending_positions_ = true;
  }
}

std::vector<float> WaveAir::own_pressures(const std::vector<double>& padded) const {
  const int own = triangle_ids_.counts[parallel::rank_of(communicator_)];
  std::vector<float> pressures(own);
  std::transform(padded.begin(), padded.begin() + own, pressures.begin(),
                 [](double pressure) { return static_cast<float>(pressure); });
  return pressures;
}

std::vector<float> WaveAir::in_global_order(std::span<const float> gathered) const {
  std::vector<float> in_order(moving_);
  for (std::size_t i = 0; i < gathered.size(); ++i) {
    in_order[triangle_ids_.values[i]] = gathered[i];
  }
  return in_order;
}

void WaveAir::receive() {
  if (!sending_) {
    return;
  }
  sending_ = false;
  history_.push(in_global_order(shared_pressures_.finish()));
  if (!sending_positions_) {
    return;
  }
  sending_positions_ = false;
  shared_positions_.finish(arrived_);
  if (have_moved(arrived_)) {
    require_within_reach(arrived_);
    std::ranges::copy(arrived_, positions_.begin());
    set_surfaces();
  }
}

bool WaveAir::have_moved(std::span<const float> positions) const {
  const auto limit = static_cast<float>(least_motion * plan_.grid.cell);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    if (!(std::abs(positions[i] - positions_[i]) <= limit)) {
      return true;
    }
  }
  return false;
}

void WaveAir::require_within_reach(std::span<const float> positions) {
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

void WaveAir::set_surfaces() {
  const waves::Obstruction obstruction{triangles_, positions_};
  waves::CutCells cut_cells(field_.slab(), obstruction);
  sources_ = waves::SurfaceSources(field_.slab(), obstruction, moving_, cut_cells, plan_.courant);
  node_sources_.resize(cut_cells.nodes().size());
  field_.set_surfaces(std::move(cut_cells));
}

void WaveAir::advance() {
  for (int step = 0; step < plan_.steps; ++step) {
    history_.changes(step, changes_);
    sources_.add(changes_, node_sources_);
    field_.step(node_sources_);
  }
}

std::optional<Ears::LocalSounds> WaveAir::sounds_at(const Vector3& place) const {
  const Vector3 in_cells = plan_.grid.in_cells(place);
  if (!plan_.enclosure.contains(in_cells)) {
    return {};
  }
  // Linear between the centres of eight cells.
  Ears::LocalSounds sounds{};
  std::array<int, 3> first{};
  Vector3 part;
  for (int axis = 0; axis < 3; ++axis) {
    first[axis] = static_cast<int>(std::floor(in_cells[axis] - 0.5));
    part[axis] = in_cells[axis] - 0.5 - first[axis];
  }
  for (int corner = 0; corner < 8; ++corner) {
    std::array<int, 3> cell = first;
    double weight = 1.0;
    for (int axis = 0; axis < 3; ++axis) {
      const bool upper = (corner >> axis & 1) != 0;
      cell[axis] += upper ? 1 : 0;
      weight *= upper ? part[axis] : 1.0 - part[axis];
    }
    cell[2] = std::max(cell[2], 0);  // below is the mirror image
    if (field_.slab().owns(cell[2])) {
      sounds[corner] = weight * field_.pressure(field_.slab().number(cell[0], cell[1], cell[2]));
    }
  }
  return sounds;
}

void WaveAir::archive(parallel::Archive& archive) {
  receive();
  std::vector<double> positions(positions_.begin(), positions_.end());
  archive.root("waves/positions", positions);
  std::vector<double> pressures = history_.samples();
  archive.root("waves/pressures", pressures);
  if (archive.restoring()) {
    positions_.assign(positions.begin(), positions.end());
    history_.restore(pressures);
    set_surfaces();
  }
  field_.archive(archive);
  ears_.archive(archive, box_rows_);
}

}  // namespace idiophone::hearing
