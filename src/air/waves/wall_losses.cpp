#include "wall_losses.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "cell_rows.hpp"
#include "sub_voxels.hpp"

namespace idiophone::waves {

namespace {

/// The axis of a way between nodes of two neighbouring cells; 3 in one cell.
std::size_t axis_between(const Node& node, const Node& other) {
  std::size_t axis = 0;
  while (axis < 3 && node.cell.at(axis) == other.cell.at(axis)) {
    ++axis;
  }
  return axis;
}

/// Friction of all nodes, with that of the neighbours' nodes, [nodes x 3].
std::vector<float> shared_friction(const CutCells& cut_cells, const FaceExchange& exchange) {
  std::vector<float> friction;
  for (const WallShare& share : cut_cells.walls()) {
    friction.insert(friction.end(), share.friction.begin(), share.friction.end());
  }
  exchange.exchange_nodes(friction, 3);
  return friction;
}

/// The node of a cell before that has the most air in common with a node; -1 for none.
Index node_before(const Node& node, const CutCells& before) {
  const auto [first, last] = before.nodes_of(node.cell);
  Index best = -1;
  int most = 0;
  for (Index one = first; one < last; ++one) {
    const int common = overlap(before.nodes()[one].mask, node.mask);
    if (common > most) {
      most = common;
      best = one;
    }
  }
  return best;
}

}  // namespace

WallLosses::WallLosses(const Subdomain& subdomain, const CutCells& cut_cells, const LossyAir& air, double courant,
                       const FaceExchange& exchange)
    : subdomain_(subdomain) {
  const double step = courant * subdomain.grid().cell / air.speed;
  const double thickness = std::sqrt(air.viscosity * step) / subdomain.grid().cell;  // of a boundary layer, in cells
  const double of_heat = (air.heat_ratio - 1.0) * std::sqrt(air.diffusivity * step) / subdomain.grid().cell;
  const std::vector<float> friction = shared_friction(cut_cells, exchange);
  std::vector<float> ways, nodes;
  for (Index node = 0; node < cut_cells.own_nodes(); ++node) {
    const Node& here = cut_cells.nodes()[node];
    const float area = cut_cells.walls()[node].area;
    if (area > 0.0F) {
      cooled_.push_back(node);
      nodes.push_back(static_cast<float>(of_heat) * area / here.volume);
    }
    const auto [first, last] = cut_cells.links_of(node);
    for (Index link = first; link < last; ++link) {
      const Index other = cut_cells.links()[link].to - subdomain.length();
      const std::size_t axis = other < 0 ? 3 : axis_between(here, cut_cells.nodes()[other]);
      const float rubbed = axis == 3 ? 0.0F : friction[3UL * node + axis] + friction[3UL * other + axis];
      if (rubbed > 0.0F) {
        const auto square = static_cast<float>(courant * courant);
        ways_.push_back({node, other, square / here.volume * cut_cells.links()[link].area});
        ways.push_back(static_cast<float>(thickness) * rubbed);
      }
    }
  }
  friction_ = HalfDerivative(std::move(ways), step);
  heat_ = HalfDerivative(std::move(nodes), step);
  for (std::vector<float>* one : {&flow_, &push_, &slowed_}) {
    one->resize(friction_.length());
  }
  for (std::vector<float>* one : {&pressure_, &gain_, &lost_}) {
    one->resize(heat_.length());
  }
}

void WallLosses::slow(std::span<const float> pressure, std::span<float> rate) {
  const auto of_nodes = pressure.subspan(subdomain_.length());
  for (std::size_t i = 0; i < ways_.size(); ++i) {
    push_[i] = of_nodes[ways_[i].other] - of_nodes[ways_[i].node];
  }
  friction_.losses(flow_, push_, slowed_);
  for (std::size_t i = 0; i < ways_.size(); ++i) {
    rate[ways_[i].node] -= ways_[i].weight * slowed_[i];
  }
}

void WallLosses::cool(std::span<const float> pressure, std::span<float> rate) {
  for (std::size_t i = 0; i < cooled_.size(); ++i) {
    pressure_[i] = pressure[subdomain_.length() + cooled_[i]];
    gain_[i] = rate[cooled_[i]];
  }
  heat_.losses(pressure_, gain_, lost_);
  for (std::size_t i = 0; i < cooled_.size(); ++i) {
    rate[cooled_[i]] -= lost_[i];
  }
}

void WallLosses::advance() {
  friction_.advance(flow_, push_, slowed_);
  for (std::size_t i = 0; i < flow_.size(); ++i) {
    flow_[i] += push_[i] - slowed_[i];
  }
  heat_.advance(pressure_, gain_, lost_);
}

void WallLosses::rest(std::span<const float> pressure) {
  for (std::size_t i = 0; i < cooled_.size(); ++i) {
    heat_.rest(i, pressure[subdomain_.length() + cooled_[i]]);
  }
}

Index WallLosses::find_way(Index node, Index other) const {
  const auto [first, last] = std::ranges::equal_range(ways_, node, {}, &Way::node);
  const auto found = std::find_if(first, last, [other](const Way& way) { return way.other == other; });
  return found == last ? -1 : static_cast<Index>(found - ways_.begin());
}

Index WallLosses::find_cooled(Index node) const {
  const auto found = std::ranges::lower_bound(cooled_, node);
  return found == cooled_.end() || *found != node ? -1 : static_cast<Index>(found - cooled_.begin());
}

void WallLosses::take_past(const CutCells& cut_cells, const WallLosses& before, const CutCells& cut_cells_before) {
  std::vector<Index> old(cut_cells.nodes().size());
  std::ranges::transform(cut_cells.nodes(), old.begin(),
                         [&](const Node& node) { return node_before(node, cut_cells_before); });
  for (std::size_t i = 0; i < ways_.size(); ++i) {
    const Index its = before.find_way(old[ways_[i].node], old[ways_[i].other]);
    if (its >= 0) {
      flow_[i] = before.flow_[its];
      friction_.copy(i, before.friction_, its);
    }
  }
  for (std::size_t i = 0; i < cooled_.size(); ++i) {
    const Index its = before.find_cooled(old[cooled_[i]]);
    if (its >= 0) {
      heat_.copy(i, before.heat_, its);
    }
  }
}

void WallLosses::archive(const CutCells& cut_cells, parallel::Archive& archive) {
  std::vector<std::array<int, 3>> of_ways, of_cooled;
  for (const Way& way : ways_) {
    of_ways.push_back(cut_cells.nodes()[way.node].cell);
  }
  for (const Index node : cooled_) {
    of_cooled.push_back(cut_cells.nodes()[node].cell);
  }
  const Grid& grid = subdomain_.grid();
  archive.rows("waves/wall_flow", rows_by_cell(grid, of_ways, archive.communicator()),
               [this](std::size_t way, parallel::ArchiveRow& row) {
                 row.value(flow_[way]);
                 friction_.archive(way, row);
               });
  archive.rows("waves/wall_heat", rows_by_cell(grid, of_cooled, archive.communicator()),
               [this](std::size_t node, parallel::ArchiveRow& row) { heat_.archive(node, row); });
}

}  // namespace idiophone::waves
