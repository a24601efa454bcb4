#include "transfer.hpp"

#include "sub_voxels.hpp"

namespace idiophone::waves {

namespace {

struct Values {
  float pressure = 0.0F, rate = 0.0F;
};

/// Reads a field whose surfaces are still those before.
class Before {
 public:
  explicit Before(const FieldState& field) : subdomain_(field.subdomain), field_(field) {}

  /// Of the air in some sub-voxels of a cell.
  [[nodiscard]] Values in(const std::array<int, 3>& cell, const Mask& mask) const {
    const Index number = subdomain_.number(cell);
    if (field_.cut_cells.is_solid(cell)) {
      return around(cell);
    }
    const auto [first, last] = field_.cut_cells.nodes_of(cell);
    if (first == last) {
      return {field_.pressure[number], field_.rate[number]};
    }
    Values sum;
    float weights = 0.0F;
    for (Index node = first; node < last; ++node) {
      const auto weight = static_cast<float>(overlap(field_.cut_cells.nodes()[node].mask, mask));
      sum.pressure += weight * field_.pressure[subdomain_.length() + node];
      sum.rate += weight * field_.node_rate[node];
      weights += weight;
    }
    return weights > 0.0F ? Values{sum.pressure / weights, sum.rate / weights} : around(cell);
  }

 private:
  [[nodiscard]] Values around(const std::array<int, 3>& cell) const {
    float sum = 0.0F, weights = 0.0F;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const int step : {-1, 1}) {
        auto next = cell;
        next.at(axis) += step;
        if (!field_.cut_cells.is_solid(next)) {
          sum += field_.pressure[subdomain_.number(next)];
          weights += 1.0F;
        }
      }
    }
    return {weights > 0.0F ? sum / weights : 0.0F, 0.0F};
  }

  const Subdomain& subdomain_;
  const FieldState& field_;
};

}  // namespace

void transfer(FieldState& field, const CutCells& now) {
  const Before before(field);
  const std::size_t nodes = now.nodes().size();
  std::vector<float> node_pressure(nodes), node_rate(nodes);
  for (Index node = 0; node < now.own_nodes(); ++node) {
    const Values values = before.in(now.nodes()[node].cell, now.nodes()[node].mask);
    node_pressure[node] = values.pressure;
    node_rate[node] = values.rate;
  }
  struct Opened {
    Index number;
    Values values;
  };
  std::vector<Opened> opened;  // cells that had nodes and have none now; others remain as they are
  const auto& old = field.cut_cells;
  for (Index node = 0; node < old.own_nodes(); ++node) {
    const auto& cell = old.nodes()[node].cell;
    const auto [first, last] = now.nodes_of(cell);
    if (first == last) {
      opened.push_back({field.subdomain.number(cell), before.in(cell, full_mask)});
    }
  }
  for (const auto& [number, values] : opened) {
    field.pressure[number] = values.pressure;
    field.rate[number] = values.rate;
  }
  field.pressure.resize(field.subdomain.length());
  field.pressure.insert(field.pressure.end(), node_pressure.begin(), node_pressure.end());
  field.node_rate = std::move(node_rate);
}

}  // namespace idiophone::waves
