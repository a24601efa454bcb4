#include "wave_air.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "idiophone/foundation/parallel/communicator.hpp"

namespace idiophone::propagation {

WaveAir::WaveAir(const scene::Acoustics& acoustics, const propagation::AudibleSurface& surface, std::int64_t steady,
                 parallel::Stages& stages, MPI_Comm communicator, accelerator::Accelerator* accelerator)
    : acoustics_(acoustics),
      stages_(stages),
      communicator_(communicator),
      grid_(acoustics, surface, communicator, accelerator),
      triangle_ids_(parallel::gather_all(std::span<const Index>(surface.triangle_ids), communicator)),
      shared_pressures_(triangle_ids_.counts, communicator),
      history_(grid_.moving(), grid_.plan().steps),
      ears_(acoustics, steady + 1 - latency(), grid_.patches()) {}

void WaveAir::start(std::int64_t /*sample*/, const surface::SurfaceMotion& steady) {
  grid_.start(steady);
  const bool blocked = acoustics_.audio.dc_loss > 0.0;  // what has lasted for ever is not heard
  shared_pressures_.begin(own_pressures(blocked ? std::vector<double>(grid_.moving()) : steady.pressure));
  history_.fill(in_global_order(shared_pressures_.finish()));
}

void WaveAir::propagate(std::int64_t sample, const surface::Emission& emission, const surface::SurfaceMotion& motion) {
  const parallel::Stages::Scope stage(stages_, parallel::Stage::radiation);
  if (grid_.failed()) {
    return;
  }
  receive();
  shared_pressures_.begin(own_pressures(emission.pressure));
  sending_ = true;
  grid_.send_positions(sample, motion);
  for (int step = 0; step < grid_.plan().steps; ++step) {
    grid_.step(history_, step);
  }
  ears_.hear(sample - latency(), grid_.emission(), nullptr, [this](const Vector3& place) { return sounds_at(place); });
}

std::vector<float> WaveAir::own_pressures(const std::vector<double>& padded) const {
  const int own = triangle_ids_.counts[parallel::rank_of(communicator_)];
  std::vector<float> pressures(own);
  std::transform(padded.begin(), padded.begin() + own, pressures.begin(),
                 [](double pressure) { return static_cast<float>(pressure); });
  return pressures;
}

std::vector<float> WaveAir::in_global_order(std::span<const float> gathered) const {
  std::vector<float> in_order(grid_.moving());
  for (std::size_t i = 0; i < gathered.size(); ++i) {
    in_order[triangle_ids_.values[i]] = gathered[i];
  }
  return in_order;
}

void WaveAir::receive() {
  if (sending_) {
    sending_ = false;
    history_.push(in_global_order(shared_pressures_.finish()));
  }
  grid_.receive_positions();
}

std::optional<Ears::LocalSounds> WaveAir::sounds_at(const Vector3& place) const {
  const Vector3 in_cells = grid_.plan().grid.in_cells(place);
  if (!grid_.plan().enclosure.contains(in_cells)) {
    return {};
  }
  // Linear between the centres of eight cells.
  Ears::LocalSounds sounds{};
  std::vector<int> corners;  // in cells of this rank
  std::vector<Index> cells;
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
    const waves::Subdomain& subdomain = grid_.field().subdomain();
    if (subdomain.owns(cell)) {
      sounds[corner] = weight;
      corners.push_back(corner);
      cells.push_back(subdomain.number(cell));
    }
  }
  std::vector<float> pressures(cells.size());
  grid_.field().probe(cells)->read(pressures);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    sounds[corners[i]] *= pressures[i];
  }
  return sounds;
}

void WaveAir::archive(parallel::Archive& archive) {
  receive();
  grid_.archive(archive);
  std::vector<double> pressures = history_.samples();
  archive.root("waves/pressures", pressures);
  if (archive.restoring()) {
    history_.restore(pressures);
  }
  ears_.archive(archive, grid_.patch_rows());
}

}  // namespace idiophone::propagation
