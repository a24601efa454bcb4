#include "idiophone/air/waves/wave_field.hpp"

#include <utility>

#include "accelerator_steps.hpp"
#include "face_exchange.hpp"
#include "field_state.hpp"
#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/foundation/parallel/errors.hpp"
#include "processor_steps.hpp"
#include "transfer.hpp"

namespace idiophone::waves {

WaveField::WaveField(const Division& division, double courant, MPI_Comm communicator,
                     const std::optional<LossyAir>& lossy, accelerator::Accelerator* accelerator)
    : lossy_(lossy), exchange_(std::make_unique<FaceExchange>(division, communicator)) {
  const Subdomain subdomain = division.subdomain(parallel::rank_of(communicator));
  const auto boxes = accelerator ? std::vector{subdomain.cells()} : boxes_from_faces(subdomain);
  state_ = std::make_unique<FieldState>(subdomain, boxes, static_cast<float>(courant));
  if (accelerator) {
    parallel::collectively(communicator,
                           [&] { steps_ = std::make_unique<AcceleratorSteps>(*accelerator, *state_, *exchange_); });
  } else {
    steps_ = std::make_unique<ProcessorSteps>(*state_, *exchange_);
  }
}

WaveField::~WaveField() = default;

const Subdomain& WaveField::subdomain() const {
  return state_->subdomain;
}

const CutCells& WaveField::cut_cells() const {
  return state_->cut_cells;
}

void WaveField::set_surfaces(CutCells cut_cells) {
  steps_->save();
  transfer(*state_, cut_cells);
  const CutCells before = std::exchange(state_->cut_cells, std::move(cut_cells));
  exchange_->set_nodes(state_->cut_cells);
  if (lossy_) {
    renew_losses(before);
  }
  exchange();
  steps_->load();
}

void WaveField::renew_losses(const CutCells& before) {
  FieldState& state = *state_;
  auto losses = std::make_unique<WallLosses>(state.subdomain, state.cut_cells, *lossy_, state.courant, *exchange_);
  losses->rest(state.pressure);
  if (state.losses) {
    losses->take_past(state.cut_cells, *state.losses, before);
  }
  state.losses = std::move(losses);
}

void WaveField::exchange() {
  exchange_->start([this](Index cell) { return state_->pressure[cell]; }, state_->node_pressures());
  exchange_->finish(state_->pressure, state_->node_pressures());
  state_->publish_nodes();
}

void WaveField::step(std::span<const float> sources) {
  steps_->step(sources);
}

void WaveField::step(const SurfaceSources& sources, const VelocityHistory& velocities, int step) {
  steps_->step(sources, velocities, step);
}

void WaveField::forecast(std::span<float> pressures) {
  steps_->forecast(pressures);
}

float WaveField::pressure(Index cell) const {
  return steps_->pressure(cell);
}

void WaveField::set_pressure(Index cell, float pressure) {
  steps_->set_pressure(cell, pressure);
}

std::unique_ptr<PressureProbe> WaveField::probe(std::vector<Index> cells) const {
  return steps_->probe(std::move(cells));
}

}  // namespace idiophone::waves
