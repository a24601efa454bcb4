#include "processor_steps.hpp"

#include <algorithm>
#include <utility>

#include "flush_to_zero.hpp"

namespace idiophone::waves {

namespace {

class ProcessorProbe : public PressureProbe {
 public:
  ProcessorProbe(const std::vector<float>& field, std::vector<Index> cells)
      : field_(field), cells_(std::move(cells)), values_(cells_.size()) {}

  void set_cells(std::span<const Index> cells) override {
    cells_.assign(cells.begin(), cells.end());
    values_.resize(cells.size());
  }
  void begin() override {
    std::ranges::transform(cells_, values_.begin(), [this](Index cell) { return field_[cell]; });
  }
  std::span<const float> finish() override { return values_; }

 private:
  const std::vector<float>& field_;
  std::vector<Index> cells_;
  std::vector<float> values_;
};

}  // namespace

void ProcessorSteps::step(std::span<const float> sources) {
  const FlushToZero flush;
  std::vector<float>& pressure = state_.pressure;
  std::vector<float>& rate = state_.rate;
  std::vector<CellUpdate>& updates = state_.updates;
  update_node_rates(sources);
  advance_nodes();  // their cells keep the pressures before the step until the nodes are published
  const CellBox& cells = state_.subdomain.cells();
  const auto at_faces = std::span(updates).first(updates.size() - 1);
  for (CellUpdate& face : at_faces) {
    for (int z = face.cells().from[2]; z < face.cells().to[2]; ++z) {
      face.add_rates(z, pressure, rate);
    }
  }
  exchange_.start([this](Index cell) { return state_.pressure[cell] + state_.rate[cell]; }, state_.node_pressures());
  // A plane's pressures advance as soon as its upper neighbour has read them, while they are in the cache.
  for (int z = cells.from[2]; z < cells.to[2]; ++z) {
    updates.back().add_rates(z, pressure, rate);
    if (z > cells.from[2]) {
      advance_plane(z - 1);
    }
  }
  advance_plane(cells.to[2] - 1);
  exchange_.finish(pressure, state_.node_pressures());
  state_.publish_nodes();
}

void ProcessorSteps::step(const SurfaceSources& sources, const VelocityHistory& velocities, int step) {
  velocities_.resize(velocities.signals());
  velocities.changes(step, velocities_);
  sources_.resize(state_.cut_cells.nodes().size());
  sources.add(velocities_, sources_);
  this->step(sources_);
}

float ProcessorSteps::inflow(Index node) const {
  const std::vector<float>& pressure = state_.pressure;
  const float here = pressure[state_.subdomain.length() + node];
  const Link* const links = state_.cut_cells.links().data();
  const auto [first, last] = state_.cut_cells.links_of(node);
  float flow = 0.0F;
  for (const Link* link = links + first; link != links + last; ++link) {
    flow += link->area * (pressure[link->to] - here);
  }
  return state_.courant * state_.courant / state_.cut_cells.nodes()[node].volume * flow;
}

void ProcessorSteps::update_node_rates(std::span<const float> sources) {
  for (Index node = 0; node < state_.cut_cells.own_nodes(); ++node) {
    state_.node_rate[node] += inflow(node) + sources[node];
  }
  if (state_.losses) {
    state_.losses->slow(state_.pressure, state_.node_rate);
  }
}

void ProcessorSteps::forecast(std::span<float> pressures) {
  const FlushToZero flush;
  for (Index node = 0; node < state_.cut_cells.own_nodes(); ++node) {
    pressures[node] = state_.node_rate[node] + inflow(node);
  }
  if (state_.losses) {
    state_.losses->slow(state_.pressure, pressures);
    state_.losses->cool(state_.pressure, pressures);
  }
  for (Index node = 0; node < state_.cut_cells.own_nodes(); ++node) {
    pressures[node] = state_.node_pressures()[node] + pressures[node] / 2.0F;
  }
}

void ProcessorSteps::advance_plane(int z) {
  const CellBox& cells = state_.subdomain.cells();
  const int length = cells.width(0);
  for (int y = cells.from[1]; y < cells.to[1]; ++y) {
    const Index first = state_.subdomain.number({cells.from[0], y, z});
    float* const __restrict pressure = &state_.pressure[first];
    const float* const __restrict rate = &state_.rate[first];
    for (int x = 0; x < length; ++x) {
      pressure[x] += rate[x];
    }
  }
}

void ProcessorSteps::advance_nodes() {
  std::span<const float> change = state_.node_rate;
  if (state_.losses) {
    change_ = state_.node_rate;
    state_.losses->cool(state_.pressure, change_);
    state_.losses->advance();
    change = change_;
  }
  const std::span<float> pressure = state_.node_pressures();
  for (Index node = 0; node < state_.cut_cells.own_nodes(); ++node) {
    pressure[node] += change[node];
  }
}

std::unique_ptr<PressureProbe> ProcessorSteps::probe(std::vector<Index> cells) const {
  return std::make_unique<ProcessorProbe>(state_.pressure, std::move(cells));
}

}  // namespace idiophone::waves
