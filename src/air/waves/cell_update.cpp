#include "cell_update.hpp"

#include "step_formulas.hpp"

namespace idiophone::waves {

CellUpdate::CellUpdate(const Subdomain& subdomain, const CellBox& cells, float courant)
    : subdomain_(subdomain), cells_(cells), square_(courant * courant) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const int end : {0, 1}) {
      if (!common(cells, layer_cells(subdomain.grid(), axis, end)).is_empty()) {
        layers_.emplace_back(subdomain, cells, axis, end, courant);
      }
    }
  }
}

void CellUpdate::add_rates(int z, std::span<const float> pressure, std::span<float> rate) {
  if (z < cells_.from[2] || z >= cells_.to[2]) {
    return;
  }
  for (AbsorbingLayer& layer : layers_) {
    layer.add(z, pressure, rate);
  }
  const float square = square_;
  const Index row = subdomain_.stride(1);
  const Index plane = subdomain_.stride(2);
  const int length = cells_.width(0);
  for (int y = cells_.from[1]; y < cells_.to[1]; ++y) {
    const Index first = subdomain_.number({cells_.from[0], y, z});
    const float* const here = &pressure[first];
    float* const __restrict rates = &rate[first];
    for (int x = 0; x < length; ++x) {
      const float p = here[x];
      const float along_x = inflow_along(p, here[x - 1], here[x + 1]);
      const float along_y = inflow_along(p, here[x - row], here[x + row]);
      const float along_z = inflow_along(p, here[x - plane], here[x + plane]);
      rates[x] += square * inflow_of_cell(along_x, along_y, along_z);
    }
  }
}

std::vector<CellBox> boxes_from_faces(const Subdomain& subdomain) {
  std::vector<CellBox> boxes;
  CellBox rest = subdomain.cells();
  for (const std::size_t axis : {2, 1, 0}) {
    const int thickness = axis == 0 ? Grid::row_multiple : 1;  // rows are computed in whole vectors
    if (subdomain.cells().from.at(axis) > 0 && !rest.is_empty()) {
      CellBox& face = boxes.emplace_back(rest);
      face.to.at(axis) = rest.from.at(axis) += thickness;
    }
    if (subdomain.cells().to.at(axis) < subdomain.grid().cells.at(axis) && !rest.is_empty()) {
      CellBox& face = boxes.emplace_back(rest);
      face.from.at(axis) = rest.to.at(axis) -= thickness;
    }
  }
  boxes.push_back(rest);
  return boxes;
}

}  // namespace idiophone::waves
