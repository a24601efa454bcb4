#include "idiophone/air/waves/wave_field.hpp"

#include <algorithm>
#include <utility>

#include "cell_update.hpp"
#include "face_exchange.hpp"
#include "flush_to_zero.hpp"
#include "idiophone/foundation/parallel/communicator.hpp"
#include "transfer.hpp"
#include "wall_losses.hpp"

namespace idiophone::waves {

WaveField::WaveField(const Division& division, double courant, MPI_Comm communicator,
                     const std::optional<LossyAir>& lossy)
    : subdomain_(division.subdomain(parallel::rank_of(communicator))),
      courant_(static_cast<float>(courant)),
      lossy_(lossy),
      cut_cells_(subdomain_),
      exchange_(std::make_unique<FaceExchange>(division, communicator)),
      pressure_(subdomain_.length()),
      rate_(subdomain_.length()) {
  for (const CellBox& cells : boxes_from_faces(subdomain_)) {
    updates_.emplace_back(subdomain_, cells, courant_);
  }
}

WaveField::~WaveField() = default;

void WaveField::set_surfaces(CutCells cut_cells) {
  transfer(subdomain_, {cut_cells_, pressure_, rate_, node_rate_}, cut_cells);
  const CutCells before = std::exchange(cut_cells_, std::move(cut_cells));
  exchange_->set_nodes(cut_cells_);
  if (lossy_) {
    renew_losses(before);
  }
  exchange();
}

void WaveField::renew_losses(const CutCells& before) {
  auto losses = std::make_unique<WallLosses>(subdomain_, cut_cells_, *lossy_, courant_, *exchange_);
  losses->rest(pressure_);
  if (losses_) {
    losses->take_past(cut_cells_, *losses_, before);
  }
  losses_ = std::move(losses);
}

void WaveField::step(std::span<const float> sources) {
  const FlushToZero flush;
  update_node_rates(sources);
  advance_nodes();  // their cells keep the pressures before the step until the nodes are published
  const CellBox& cells = subdomain_.cells();
  const auto at_faces = std::span(updates_).first(updates_.size() - 1);
  for (CellUpdate& face : at_faces) {
    for (int z = face.cells().from[2]; z < face.cells().to[2]; ++z) {
      face.add_rates(z, pressure_, rate_);
    }
  }
  exchange_->start([this](Index cell) { return pressure_[cell] + rate_[cell]; }, node_pressures());
  // A plane's pressures advance as soon as its upper neighbour has read them, while they are in the cache.
  for (int z = cells.from[2]; z < cells.to[2]; ++z) {
    updates_.back().add_rates(z, pressure_, rate_);
    if (z > cells.from[2]) {
      advance_plane(z - 1);
    }
  }
  advance_plane(cells.to[2] - 1);
  finish_exchange();
}

float WaveField::inflow(Index node) const {
  const float here = pressure_[subdomain_.length() + node];
  const Link* const links = cut_cells_.links().data();
  const auto [first, last] = cut_cells_.links_of(node);
  float flow = 0.0F;
  for (const Link* link = links + first; link != links + last; ++link) {
    flow += link->area * (pressure_[link->to] - here);
  }
  return courant_ * courant_ / cut_cells_.nodes()[node].volume * flow;
}

void WaveField::update_node_rates(std::span<const float> sources) {
  for (Index node = 0; node < cut_cells_.own_nodes(); ++node) {
    node_rate_[node] += inflow(node) + sources[node];
  }
  if (losses_) {
    losses_->slow(pressure_, node_rate_);
  }
}

void WaveField::forecast(std::span<float> pressures) {
  const FlushToZero flush;
  for (Index node = 0; node < cut_cells_.own_nodes(); ++node) {
    pressures[node] = node_rate_[node] + inflow(node);
  }
  if (losses_) {
    losses_->slow(pressure_, pressures);
    losses_->cool(pressure_, pressures);
  }
  for (Index node = 0; node < cut_cells_.own_nodes(); ++node) {
    pressures[node] = pressure_[subdomain_.length() + node] + pressures[node] / 2.0F;
  }
}

void WaveField::advance_plane(int z) {
  const CellBox& cells = subdomain_.cells();
  const int length = cells.width(0);
  for (int y = cells.from[1]; y < cells.to[1]; ++y) {
    const Index first = subdomain_.number({cells.from[0], y, z});
    float* const __restrict pressure = &pressure_[first];
    const float* const __restrict rate = &rate_[first];
    for (int x = 0; x < length; ++x) {
      pressure[x] += rate[x];
    }
  }
}

void WaveField::advance_nodes() {
  std::span<const float> change = node_rate_;
  if (losses_) {
    change_ = node_rate_;
    losses_->cool(pressure_, change_);
    losses_->advance();
    change = change_;
  }
  for (Index node = 0; node < cut_cells_.own_nodes(); ++node) {
    pressure_[subdomain_.length() + node] += change[node];
  }
}

void WaveField::publish_nodes() {
  const auto& nodes = cut_cells_.nodes();
  for (Index node = static_cast<Index>(nodes.size()) - 1; node >= 0; --node) {
    const Index cell = subdomain_.number(nodes[node].cell);  // backwards, so that the first of a cell remains
    pressure_[cell] = pressure_[subdomain_.length() + node];
    rate_[cell] = 0.0F;
  }
  for (const SolidRun& run : cut_cells_.solids()) {
    std::fill_n(&pressure_[run.first], run.length, 0.0F);
    std::fill_n(&rate_[run.first], run.length, 0.0F);
  }
}

void WaveField::exchange() {
  exchange_->start([this](Index cell) { return pressure_[cell]; }, node_pressures());
  finish_exchange();
}

void WaveField::finish_exchange() {
  exchange_->finish(pressure_, node_pressures());
  publish_nodes();
  if (subdomain_.grid().rigid_below && subdomain_.cells().from[2] == 0) {  // the mirror image
    const Index plane = subdomain_.stride(2);
    std::copy_n(&pressure_[plane], plane, pressure_.data());
  }
}

}  // namespace idiophone::waves
