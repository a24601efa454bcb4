#include "idiophone/solids/accuracy/recommendation.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "idiophone/foundation/element/lobatto.hpp"

namespace idiophone::accuracy {

namespace {

constexpr int most_along = 500;
constexpr int most_layers = 8;
constexpr int highest_order = 6;         // higher ones are never cheaper: docs/pictures/error_over_cost.png
constexpr double safety = 0.9;           // of the stable step, as decks have it by default
constexpr double hex_nodes_rate = 30e6;  // nodes of hexahedra a second and core, of a busy machine
constexpr double tet10_rate = 13e6;      // elements likewise
constexpr double tet4_rate = 55e6;       // elements likewise
constexpr double tetrahedra_of_cell = 6;
constexpr double hex_step = 0.93;    // of the node spacing over the wave speed, measured
constexpr double tet10_step = 0.70;  // likewise

/// Processor time of a second of sound, s.
/// @param work  nodes of hexahedra or elements of tetrahedra
/// @param step  stable step, s
double seconds_of_work(double work, const element::Type& type, double step) {
  const double steps = 1 / (safety * step);
  switch (type.kind) {
    case element::Kind::tet4:
      return work * steps / tet4_rate;
    case element::Kind::tet10:
      return work * steps / tet10_rate;
    case element::Kind::hex:
      return work * steps / hex_nodes_rate;
  }
  element::unknown_kind();
}

/// Part of a cell between its closest nodes, of order p.
double closest_nodes(int order) {
  const Eigen::VectorXd& nodes = element::lobatto(order).nodes;
  return (nodes[1] - nodes[0]) / 2;
}

/// Of the node spacing over the wave speed.
double step_share(element::Type type) {
  switch (type.kind) {
    case element::Kind::tet4:
    case element::Kind::tet10:
      return tet10_step;
    case element::Kind::hex:
      return hex_step;
  }
  element::unknown_kind();
}

/// Stable step, s: spacings of the nodes in three directions over the speed of waves of compression.
double step_of(const Cells& cells, const scene::Material& material) {
  const element::Orders orders = element::orders(cells.type);
  const double plane = closest_nodes(orders.plane);
  const double through = closest_nodes(orders.thickness);
  const double sum =
      std::pow(plane * cells.size, -2) + std::pow(plane * cells.across, -2) + std::pow(through * cells.layer, -2);
  const double squeeze = 1 - material.poisson - 2 * material.poisson * material.poisson;
  const double young =
      material.is_isotropic() ? material.young * (1 - material.poisson) / std::max(squeeze, 0.1) : material.young;
  return step_share(cells.type) / std::sqrt(sum * young / material.density);
}

/// Nodes of hexahedra or elements of tetrahedra in a body of a volume (m3).
double work_of(const Cells& cells, int layers, double thickness, double volume) {
  const double columns = volume / (thickness * cells.size * cells.across);
  switch (cells.type.kind) {
    case element::Kind::tet4:
    case element::Kind::tet10:
      return columns * layers * tetrahedra_of_cell;
    case element::Kind::hex: {
      const double edges = 2 * cells.type.plane * std::sqrt(columns) + 1;  // nodes on two sides of a square
      return (columns * cells.type.plane * cells.type.plane + edges) * (layers * cells.type.thickness + 1);
    }
  }
  element::unknown_kind();
}

/// The cheapest mesh of a type and a number of layers: the coarsest that is accurate enough.
std::optional<Recommendation> coarsest(element::Type type, int layers, const Extents& body, double volume,
                                       const scene::Material& material, const Accuracy& wanted) {
  for (int along = 1; along <= most_along; ++along) {
    const double size = body.sides[0] / along;
    const Cells cells{.type = type,
                      .size = size,
                      .across = body.sides[1] / std::ceil(body.sides[1] / size - 1e-6),
                      .layer = body.thickness / layers};
    const double error = pitch_error(cells, body, material, wanted.frequency);
    if (error <= wanted.cents) {
      const double work = work_of(cells, layers, body.thickness, volume);
      return Recommendation{cells, layers, error, seconds_of_work(work, type, step_of(cells, material))};
    }
  }
  return {};
}

std::vector<element::Type> types_of(element::Kind kind) {
  if (!element::has_choice_of_orders(element::Type{kind})) {
    return {element::Type{kind}};
  }
  std::vector<element::Type> types;
  for (int plane = 3; plane <= highest_order; ++plane) {
    for (int through = element::lowest_hex_order; through <= plane; ++through) {
      types.push_back(element::hex(plane, through));
    }
  }
  return types;
}

}  // namespace

double seconds_of(const mesh::Statistics& mesh, element::Type type, double step) {
  switch (type.kind) {
    case element::Kind::tet4:
    case element::Kind::tet10:
      return seconds_of_work(mesh.elements, type, step);
    case element::Kind::hex:
      return seconds_of_work(mesh.nodes, type, step);
  }
  element::unknown_kind();
}

std::optional<Recommendation> recommend(element::Kind kind, const Extents& body, double volume,
                                        const scene::Material& material, const Accuracy& wanted) {
  std::optional<Recommendation> best;
  for (const element::Type type : types_of(kind)) {
    for (int layers = 1; layers <= most_layers; ++layers) {
      const auto found = coarsest(type, layers, body, volume, material, wanted);
      if (found && (!best || found->seconds < best->seconds)) {
        best = found;
      }
    }
  }
  return best;
}

}  // namespace idiophone::accuracy
