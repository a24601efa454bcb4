#include "accelerator_steps.hpp"

#include <algorithm>
#include <stdexcept>

#include "idiophone/foundation/accelerator/background_read.hpp"
#include "step_table.hpp"

namespace idiophone::waves {

namespace {

class AcceleratorProbe : public PressureProbe {
 public:
  AcceleratorProbe(accelerator::Accelerator& accelerator, WaveKernels& kernels,
                   const accelerator::Array<float>& pressure, const std::vector<Index>& cells)
      : kernels_(kernels),
        pressure_(pressure),
        count_(cells.size()),
        cells_(accelerator, cells),
        values_(accelerator, cells.size()),
        read_(accelerator, cells.size()) {}

  void set_cells(std::span<const Index> cells) override {
    cells_.write(cells);
    count_ = cells.size();
  }
  void begin() override {
    if (count_ > 0) {
      kernels_.gather({count_, 1, 1}, static_cast<int>(count_), cells_, pressure_, values_);
      read_.begin(values_);
    }
  }
  std::span<const float> finish() override { return read_.finish().first(count_); }

 private:
  WaveKernels& kernels_;
  const accelerator::Array<float>& pressure_;
  std::size_t count_;
  accelerator::Array<Index> cells_;
  accelerator::Array<float> values_;
  accelerator::BackgroundRead<float> read_;
};

}  // namespace

AcceleratorSteps::Faces::Faces(accelerator::Accelerator& accelerator, std::vector<Index> its_places)
    : places(std::move(its_places)),
      values(places.size()),
      places_there(accelerator, places),
      values_there(accelerator, places.size()) {}

AcceleratorSteps::AcceleratorSteps(accelerator::Accelerator& accelerator, FieldState& state, FaceExchange& exchange)
    : accelerator_(accelerator),
      kernels_(accelerator),
      state_(state),
      exchange_(exchange),
      layers_(accelerator, state.updates.front().layers()),
      rate_(accelerator, state.rate.size()),
      pressure_(accelerator, state.pressure.size()),
      pending_(accelerator, state.pressure.size()) {
  load();
}

AcceleratorNodes& AcceleratorSteps::nodes() {
  if (!nodes_) {
    throw std::runtime_error(
        "accelerator: its memory is too small for the surfaces; use a larger cell (radiation.cell), or more ranks with "
        "one each");
  }
  return *nodes_;
}

void AcceleratorSteps::step(std::span<const float> sources) {
  const Index own = nodes().own();
  if (!given_sources_) {
    given_sources_.emplace(accelerator_, own);
  }
  given_sources_->write(sources.first(own));
  advance(*given_sources_, 0);
}

void AcceleratorSteps::step(const SurfaceSources& sources, const VelocityHistory& velocities, int step) {
  if (!velocities_ || &velocities_->history() != &velocities) {
    velocities_.emplace(kernels_, velocities);
    sources_.reset();
  }
  velocities_->update();
  const Index own = nodes().own();
  if (!sources_) {
    sources_.emplace(kernels_, sources, own, velocities.steps());
  }
  advance(sources_->of(*velocities_), step * own);
  if (step + 1 == velocities.steps()) {
    accelerator_.flush();
  }
}

void AcceleratorSteps::advance(const accelerator::Array<float>& sources, int place) {
  const Subdomain& all = state_.subdomain;
  AcceleratorNodes& nodes = this->nodes();
  const int width = all.cells().width(0), height = all.cells().width(1), depth = all.cells().width(2);
  const StepTable step{.width = width,
                       .height = height,
                       .depth = depth,
                       .first = all.number(all.cells().from),
                       .row = all.stride(1),
                       .plane = all.stride(2),
                       .cells = all.length(),
                       .mirrored = all.is_on_floor() ? 1 : 0,
                       .square = state_.courant * state_.courant,
                       .layers = layers_.count,
                       .faces = layers_.faces,
                       .next_faces = layers_.next_faces,
                       .cell_memory = layers_.cells,
                       .nodes = nodes.own(),
                       .node_planes = (nodes.own() + width * height - 1) / (width * height),
                       .nodes_advance = nodes.is_lossy() ? 0 : 1,
                       .first_source = place};
  const auto planes = static_cast<std::size_t>(step.node_planes) + static_cast<std::size_t>(depth);
  kernels_.step_field({static_cast<std::size_t>(width), static_cast<std::size_t>(height), planes}, step, layers_.tables,
                      layers_.decay, layers_.memory, nodes.held, nodes.tables, nodes.links, sources, nodes.rate,
                      pressure_, rate_, pending_);
  layers_.advance();
  if (nodes.is_lossy()) {
    nodes.take_losses(pressure_, pending_);
  }
  exchange_faces(pending_);
  std::swap(pressure_, pending_);
}

/// The state of the processor takes part in the exchange with those pressures that are exchanged.
void AcceleratorSteps::exchange_faces(accelerator::Array<float>& pressure) {
  if (ghost_faces_->places.empty()) {
    return;
  }
  Faces& own = *own_faces_;
  const std::size_t sent = own.places.size();
  kernels_.gather({sent, 1, 1}, static_cast<int>(sent), own.places_there, pressure, own.values_there);
  own.values_there.read(own.values);
  for (std::size_t i = 0; i < sent; ++i) {
    state_.pressure[own.places[i]] = own.values[i];
  }
  exchange_.start([this](Index cell) { return state_.pressure[cell]; }, state_.node_pressures());
  exchange_.finish(state_.pressure, state_.node_pressures());
  Faces& ghosts = *ghost_faces_;
  const std::size_t received = ghosts.places.size();
  std::ranges::transform(ghosts.places, ghosts.values.begin(), [this](Index place) { return state_.pressure[place]; });
  ghosts.values_there.write(ghosts.values);
  kernels_.scatter({received, 1, 1}, static_cast<int>(received), ghosts.places_there, ghosts.values_there, pressure);
}

void AcceleratorSteps::forecast(std::span<float> pressures) {
  nodes().forecast(pressure_, pressures);
}

void AcceleratorSteps::save() {
  pressure_.read(state_.pressure);
  rate_.read(state_.rate);
  layers_.save(state_.updates.front().layers());
  nodes().save(state_);
  state_.publish_nodes();  // step_field() leaves out the mirror images of cells with nodes
}

void AcceleratorSteps::load() {
  nodes_.reset();
  sources_.reset();
  given_sources_.reset();
  pressure_ = {accelerator_, state_.pressure};
  pending_ = {accelerator_, state_.pressure};
  rate_.write(state_.rate);
  layers_.load(state_.updates.front().layers());
  nodes_.emplace(kernels_, state_);
  own_faces_.emplace(accelerator_, exchange_.own_places());
  ghost_faces_.emplace(accelerator_, exchange_.ghost_places());
}

float AcceleratorSteps::pressure(Index cell) const {
  float pressure = 0.0F;
  pressure_.read({&pressure, 1}, cell);
  return pressure;
}

void AcceleratorSteps::set_pressure(Index cell, float pressure) {
  pressure_.write({&pressure, 1}, cell);
}

std::unique_ptr<PressureProbe> AcceleratorSteps::probe(std::vector<Index> cells) const {
  return std::make_unique<AcceleratorProbe>(accelerator_, kernels_, pressure_, cells);
}

}  // namespace idiophone::waves
