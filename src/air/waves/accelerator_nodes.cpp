#include "accelerator_nodes.hpp"

#include <algorithm>

namespace idiophone::waves {

namespace {

static_assert(sizeof(Link) == sizeof(Index) + sizeof(float));  // as in nodes.cl

std::vector<NodeTable> node_tables(const FieldState& state) {
  const auto& nodes = state.cut_cells.nodes();
  std::vector<NodeTable> tables;
  tables.reserve(state.cut_cells.own_nodes() + 1);
  Index links = 0;
  for (Index node = 0; node < state.cut_cells.own_nodes(); ++node) {
    const bool is_first = node == 0 || nodes[node].cell != nodes[node - 1].cell;  // of its cell
    tables.push_back({.first_link = links,
                      .cell = is_first ? state.subdomain.number(nodes[node].cell) : -1,
                      .stiffness = state.courant * state.courant / nodes[node].volume});
    links = state.cut_cells.links_of(node).second;
  }
  tables.push_back({links, -1, 0.0F});
  return tables;
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
    : tables(kernels.program.accelerator(), node_tables(state)),
      links(kernels.program.accelerator(), std::span<const Link>(state.cut_cells.links())),
      rate(kernels.program.accelerator(), std::span(state.node_rate).first(state.cut_cells.own_nodes())),
      held(kernels.program.accelerator(), held_cells(state)),
      kernels_(kernels),
      cells_(state.subdomain.length()),
      nodes_(state.cut_cells.own_nodes()),
      change_(kernels.program.accelerator(), nodes_),
      forecast_(kernels.program.accelerator(), nodes_) {
  if (state.losses) {
    losses_.emplace(kernels, *state.losses, cells_, nodes_);
  }
}

void AcceleratorNodes::take_losses(const accelerator::Array<float>& pressure, accelerator::Array<float>& next) {
  losses_->take(pressure, rate, change_, AcceleratorLosses::Past::advances);
  kernels_.advance_nodes(range(), nodes_, cells_, tables, pressure, change_, next);
}

void AcceleratorNodes::forecast(const accelerator::Array<float>& pressure, std::span<float> pressures) {
  kernels_.node_rates_at_rest(range(), nodes_, cells_, tables, links, pressure, rate, forecast_);
  if (losses_) {
    losses_->take(pressure, forecast_, change_, AcceleratorLosses::Past::stays);
  }
  kernels_.forecast_nodes(range(), nodes_, cells_, pressure, losses_ ? change_ : forecast_, forecast_);
  forecast_.read(pressures.first(nodes_));
}

void AcceleratorNodes::save(FieldState& state) const {
  rate.read(std::span(state.node_rate).first(nodes_));
  if (losses_) {
    losses_->save(*state.losses);
  }
}

}  // namespace idiophone::waves
