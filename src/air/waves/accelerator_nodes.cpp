#include "accelerator_nodes.hpp"

#include <algorithm>

namespace idiophone::waves {

namespace {

std::vector<Index> first_links(const CutCells& cut_cells) {
  std::vector<Index> first = {0};
  for (Index node = 0; node < cut_cells.own_nodes(); ++node) {
    first.push_back(cut_cells.links_of(node).second);
  }
  return first;
}

template <class T>
std::vector<T> of_links(const CutCells& cut_cells, T Link::*member) {
  std::vector<T> values;
  std::ranges::transform(cut_cells.links(), std::back_inserter(values), member);
  return values;
}

std::vector<float> stiffness(const FieldState& state) {
  std::vector<float> values;
  values.reserve(state.cut_cells.own_nodes());
  for (Index node = 0; node < state.cut_cells.own_nodes(); ++node) {
    values.push_back(state.courant * state.courant / state.cut_cells.nodes()[node].volume);
  }
  return values;
}

/// Of each own node the cell that it gives its pressure; -1 for none.
std::vector<Index> published(const FieldState& state) {
  const auto& nodes = state.cut_cells.nodes();
  std::vector<Index> cells;
  cells.reserve(state.cut_cells.own_nodes());
  for (Index node = 0; node < state.cut_cells.own_nodes(); ++node) {
    const bool is_first = node == 0 || nodes[node].cell != nodes[node - 1].cell;
    cells.push_back(is_first ? state.subdomain.number(nodes[node].cell) : -1);
  }
  return cells;
}

std::vector<unsigned char> held_cells(const FieldState& state) {
  std::vector<unsigned char> cells(state.subdomain.length());
  for (const auto& node : state.cut_cells.nodes()) {
    cells[state.subdomain.number(node.cell)] = 1;
  }
  for (const SolidRun& run : state.cut_cells.solids()) {
    std::fill_n(&cells[run.first], run.length, 1);
  }
  return cells;
}

}  // namespace

AcceleratorNodes::AcceleratorNodes(WaveKernels& kernels, const FieldState& state)
    : kernels_(kernels),
      cells_(state.subdomain.length()),
      nodes_(state.cut_cells.own_nodes()),
      first_link_(kernels.program.accelerator(), first_links(state.cut_cells)),
      to_(kernels.program.accelerator(), of_links(state.cut_cells, &Link::to)),
      area_(kernels.program.accelerator(), of_links(state.cut_cells, &Link::area)),
      stiffness_(kernels.program.accelerator(), stiffness(state)),
      rate_(kernels.program.accelerator(), std::span(state.node_rate).first(nodes_)),
      change_(kernels.program.accelerator(), nodes_),
      forecast_(kernels.program.accelerator(), nodes_),
      published_(kernels.program.accelerator(), published(state)),
      held_(kernels.program.accelerator(), held_cells(state)) {
  if (state.losses) {
    losses_.emplace(kernels, *state.losses, cells_, nodes_);
  }
}

void AcceleratorNodes::step(const CellPlaces& places, AcceleratorLayers& layers, int place,
                            const accelerator::Array<float>& sources, const accelerator::Array<float>& pressure,
                            accelerator::Array<float>& next) {
  const int advances = losses_ ? 0 : 1;
  kernels_.begin_step({static_cast<std::size_t>(layers.faces) + nodes_, 1, 1}, layers.faces, layers.count,
                      layers.tables, places.first, places.row, places.plane, layers.decay, layers.face_memory, nodes_,
                      cells_, advances, first_link_, to_, area_, stiffness_, published_, place, sources, rate_,
                      pressure, next);
  if (losses_) {
    losses_->take(pressure, rate_, change_, AcceleratorLosses::Past::advances);
    kernels_.advance_nodes(range(), nodes_, cells_, published_, pressure, change_, next);
  }
}

void AcceleratorNodes::forecast(const accelerator::Array<float>& pressure, std::span<float> pressures) {
  kernels_.node_rates_at_rest(range(), nodes_, cells_, first_link_, to_, area_, stiffness_, pressure, rate_, forecast_);
  if (losses_) {
    losses_->take(pressure, forecast_, change_, AcceleratorLosses::Past::stays);
  }
  kernels_.forecast_nodes(range(), nodes_, cells_, pressure, losses_ ? change_ : forecast_, forecast_);
  forecast_.read(pressures.first(nodes_));
}

void AcceleratorNodes::save(FieldState& state) const {
  rate_.read(std::span(state.node_rate).first(nodes_));
  if (losses_) {
    losses_->save(*state.losses);
  }
}

}  // namespace idiophone::waves
