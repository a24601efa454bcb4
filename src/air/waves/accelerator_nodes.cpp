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
  for (Index node = 0; node < state.cut_cells.own_nodes(); ++node) {
    values.push_back(state.courant * state.courant / state.cut_cells.nodes()[node].volume);
  }
  return values;
}

}  // namespace

AcceleratorNodes::Published AcceleratorNodes::published(const FieldState& state) {
  Published all;
  const auto& nodes = state.cut_cells.nodes();
  for (std::size_t node = 0; node < nodes.size(); ++node) {
    if (node == 0 || nodes[node].cell != nodes[node - 1].cell) {
      all.cells.push_back(state.subdomain.number(nodes[node].cell));
      all.nodes.push_back(static_cast<Index>(node));
    }
  }
  for (const SolidRun& run : state.cut_cells.solids()) {
    for (Index i = 0; i < run.length; ++i) {
      all.cells.push_back(run.first + i);
      all.nodes.push_back(-1);
    }
  }
  return all;
}

AcceleratorNodes::AcceleratorNodes(WaveKernels& kernels, const FieldState& state)
    : AcceleratorNodes(kernels, state, published(state)) {}

AcceleratorNodes::AcceleratorNodes(WaveKernels& kernels, const FieldState& state, const Published& published)
    : kernels_(kernels),
      cells_(state.subdomain.length()),
      nodes_(state.cut_cells.own_nodes()),
      first_link_(kernels.program.accelerator(), first_links(state.cut_cells)),
      to_(kernels.program.accelerator(), of_links(state.cut_cells, &Link::to)),
      area_(kernels.program.accelerator(), of_links(state.cut_cells, &Link::area)),
      stiffness_(kernels.program.accelerator(), stiffness(state)),
      rate_(kernels.program.accelerator(), std::span(state.node_rate).first(nodes_)),
      sources_(kernels.program.accelerator(), nodes_),
      no_sources_(kernels.program.accelerator(), nodes_),
      change_(kernels.program.accelerator(), nodes_),
      forecast_(kernels.program.accelerator(), nodes_),
      published_cells_(kernels.program.accelerator(), published.cells),
      published_nodes_(kernels.program.accelerator(), published.nodes) {
  if (state.losses) {
    losses_.emplace(kernels, *state.losses, cells_, nodes_);
  }
}

const accelerator::Array<float>& AcceleratorNodes::changes(const accelerator::Array<float>& pressure,
                                                           const accelerator::Array<float>& sources,
                                                           accelerator::Array<float>& gain,
                                                           AcceleratorLosses::Past past) {
  kernels_.add_node_rates({static_cast<std::size_t>(nodes_), 1, 1}, nodes_, cells_, first_link_, to_, area_, stiffness_,
                          pressure, rate_, sources, gain);
  if (!losses_) {
    return gain;
  }
  losses_->take(pressure, gain, change_, past);
  return change_;
}

void AcceleratorNodes::step(std::span<const float> sources, const accelerator::Array<float>& pressure,
                            accelerator::Array<float>& next) {
  sources_.write(sources.first(nodes_));
  const auto& change = changes(pressure, sources_, rate_, AcceleratorLosses::Past::advances);
  kernels_.advance_nodes({static_cast<std::size_t>(nodes_), 1, 1}, nodes_, cells_, 1.0F, pressure, change, cells_,
                         next);
}

void AcceleratorNodes::forecast(const accelerator::Array<float>& pressure, std::span<float> pressures) {
  const auto& change = changes(pressure, no_sources_, forecast_, AcceleratorLosses::Past::stays);
  kernels_.advance_nodes({static_cast<std::size_t>(nodes_), 1, 1}, nodes_, cells_, 0.5F, pressure, change, 0,
                         forecast_);
  forecast_.read(pressures.first(nodes_));
}

void AcceleratorNodes::publish(accelerator::Array<float>& pressure, accelerator::Array<float>& cell_rate) {
  const std::size_t count = published_cells_.size();
  kernels_.publish_nodes({count, 1, 1}, static_cast<int>(count), cells_, published_cells_, published_nodes_, pressure,
                         cell_rate);
}

void AcceleratorNodes::save(FieldState& state) const {
  rate_.read(std::span(state.node_rate).first(nodes_));
  if (losses_) {
    losses_->save(*state.losses);
  }
}

}  // namespace idiophone::waves
