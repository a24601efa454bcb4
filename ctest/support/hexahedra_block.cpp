#include "hexahedra_block.hpp"

#include <map>
#include <numeric>

#include "idiophone/element/lobatto.hpp"

namespace idiophone::support {

namespace {

/// Where node `place` (counted along an axis through all cells) lies, as a part of the block's size.
double position(int place, int order, int cells) {
  const int cell = std::min(place / order, cells - 1);
  return (cell + (element::lobatto(order).nodes[place - cell * order] + 1) / 2) / cells;
}

}  // namespace

mesh::Part hexahedra_block(const solid::HexahedronOrder& order, const Vector3& size, const std::array<int, 3>& cells) {
  const std::array<int, 3> orders = {order.plane, order.plane, order.thickness};
  mesh::Part part;
  mesh::BodyPart& body = part.bodies.emplace_back();
  std::map<std::array<int, 3>, Index> numbers;
  const auto number = [&](const std::array<int, 3>& place) {
    const auto [known, fresh] = numbers.try_emplace(place, static_cast<Index>(part.reference.size()));
    if (fresh) {
      Vector3& x = part.reference.emplace_back();
      for (std::size_t d = 0; d < 3; ++d) {
        x[static_cast<Eigen::Index>(d)] = size[static_cast<Eigen::Index>(d)] * position(place[d], orders[d], cells[d]);
      }
    }
    return known->second;
  };
  for (int e = 0; e < cells[0] * cells[1] * cells[2]; ++e) {
    const std::array<int, 3> cell = {e % cells[0], e / cells[0] % cells[1], e / cells[0] / cells[1]};
    for (int a = 0; a < order.nodes(); ++a) {
      const int n = order.plane + 1;
      const std::array<int, 3> inside = {a % n, a / n % n, a / n / n};
      std::array<int, 3> place;
      for (std::size_t d = 0; d < 3; ++d) {
        place[d] = cell[d] * orders[d] + inside[d];
      }
      body.elements.push_back(number(place));
    }
    body.element_ids.push_back(e);
    body.owned.push_back(1);
  }
  part.global_nodes = part.owned_nodes = body.owned_end = static_cast<Index>(part.reference.size());
  part.global_elements = static_cast<Index>(body.element_ids.size());
  part.node_ids.resize(part.reference.size());
  std::iota(part.node_ids.begin(), part.node_ids.end(), 0);
  return part;
}

}  // namespace idiophone::support
