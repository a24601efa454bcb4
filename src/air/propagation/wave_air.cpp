#include "wave_air.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

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
      ears_(acoustics, steady + 1 - latency(), grid_.patches()),
      local_pressures_(grid_.field(), grid_.plan().enclosure) {}

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
  try {
    receive();
  } catch (const std::runtime_error&) {
    hear_the_rest();  // it is earlier, and its problem is told rather than this one
    throw;
  }
  shared_pressures_.begin(own_pressures(emission.pressure));
  sending_ = true;
  grid_.send_positions(sample, motion);
  for (int step = 0; step < grid_.plan().steps; ++step) {
    grid_.step(history_, step);
  }
  const std::optional<Arrived> before = wait_for_pressures();
  begin_reads(sample - latency());
  if (before) {
    hear(*before);  // while an accelerator takes these steps
  }
}

void WaveAir::begin_reads(std::int64_t sample) {
  grid_.begin_emission();
  local_pressures_.begin(ears_.positions(sample));
  on_the_way_ = sample;
}

std::optional<WaveAir::Arrived> WaveAir::wait_for_pressures() {
  if (!on_the_way_) {
    return {};
  }
  const std::int64_t sample = *std::exchange(on_the_way_, std::nullopt);
  local_pressures_.finish();
  return Arrived{sample, grid_.finish_emission()};
}

void WaveAir::hear(const Arrived& arrived) {
  ears_.hear(arrived.sample, arrived.emission, nullptr, local_pressures_.sounds());
}

void WaveAir::finish() {
  const parallel::Stages::Scope stage(stages_, parallel::Stage::radiation);
  hear_the_rest();
}

void WaveAir::hear_the_rest() {
  if (const std::optional<Arrived> arrived = wait_for_pressures()) {
    hear(*arrived);
  }
}

void WaveAir::require_finished() const {
  if (on_the_way_) {
    throw std::logic_error("WaveAir: finish() comes before take() and archive()");
  }
}

std::vector<std::vector<double>> WaveAir::take(std::size_t count) {
  require_finished();
  return ears_.take(count, communicator_);
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

void WaveAir::archive(parallel::Archive& archive) {
  require_finished();
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
