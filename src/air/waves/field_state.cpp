#include "field_state.hpp"

#include <algorithm>

namespace idiophone::waves {

FieldState::FieldState(const Subdomain& its_subdomain, const std::vector<CellBox>& boxes, float its_courant)
    : subdomain(its_subdomain),
      courant(its_courant),
      cut_cells(its_subdomain),
      pressure(its_subdomain.length()),
      rate(its_subdomain.length()) {
  for (const CellBox& cells : boxes) {
    updates.emplace_back(subdomain, cells, courant);
  }
}

void FieldState::publish_nodes() {
  const auto& nodes = cut_cells.nodes();
  for (Index node = static_cast<Index>(nodes.size()) - 1; node >= 0; --node) {
    const Index cell = subdomain.number(nodes[node].cell);  // backwards, so that the first of a cell remains
    pressure[cell] = pressure[subdomain.length() + node];
    rate[cell] = 0.0F;
  }
  for (const SolidRun& run : cut_cells.solids()) {
    std::fill_n(&pressure[run.first], run.length, 0.0F);
    std::fill_n(&rate[run.first], run.length, 0.0F);
  }
  if (subdomain.is_on_floor()) {
    const Index plane = subdomain.stride(2);
    std::copy_n(&pressure[plane], plane, pressure.data());
  }
}

}  // namespace idiophone::waves
