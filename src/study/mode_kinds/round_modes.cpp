#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

#include "forms_of_modes.hpp"

namespace idiophone::mode_kinds {

namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

constexpr std::size_t most_rings = 14;
constexpr int highest_order = 12;  // nodal diameters
enum Component : std::size_t { radial, tangential, axial };

/// A node of a ring.
struct RingNode {
  double angle = 0.0;
  double weight = 0.0;                   ///< angle that belongs to it
  std::array<double, 3> displacement{};  ///< by components
};

/// Nodes with about the same radius, of a disc, or height, of a shell.
struct Ring {
  double radius = 0.0;  ///< mean, m
  std::vector<RingNode> nodes;
};

/// Gives each node half the way to both neighbours. @return whether the nodes go all round
bool weigh(Ring& ring) {
  constexpr double largest_gap = 0.25 * pi;
  std::ranges::sort(ring.nodes, {}, &RingNode::angle);
  const std::size_t count = ring.nodes.size();
  double widest = count < 6 ? 2.0 * pi : 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    RingNode &node = ring.nodes[i], &next = ring.nodes[(i + 1) % count];
    const double gap = next.angle - node.angle + (i + 1 == count ? 2.0 * pi : 0.0);
    node.weight += 0.5 * gap;
    next.weight += 0.5 * gap;
    widest = std::max(widest, gap);
  }
  return widest < largest_gap;
}

std::vector<Ring> rings_of(const BodyForm& form, const LocalShape& shape) {
  const bool is_disc = form.kind == BodyForm::Kind::disc;
  const std::size_t count = std::clamp<std::size_t>(static_cast<std::size_t>(shape.places.cols()) / 40, 3, most_rings);
  std::vector<Ring> rings(count);
  for (Eigen::Index n = 0; n < shape.places.cols(); ++n) {
    const Vector3 place = shape.places.col(n), way = shape.displacements.col(n);
    const double radius = std::hypot(place[0], place[1]), angle = std::atan2(place[1], place[0]);
    const double share = is_disc ? 2.0 * radius / form.extents[0] : place[2] / form.extents[2] + 0.5;
    Ring& ring =
        rings[std::min(count - 1, static_cast<std::size_t>(std::max(0.0, share) * static_cast<double>(count)))];
    ring.radius += radius;
    ring.nodes.push_back({.angle = angle,
                          .displacement = {way[0] * std::cos(angle) + way[1] * std::sin(angle),
                                           way[1] * std::cos(angle) - way[0] * std::sin(angle), way[2]}});
  }
  std::erase_if(rings, [](Ring& ring) { return !weigh(ring); });
  for (Ring& ring : rings) {
    ring.radius /= static_cast<double>(ring.nodes.size());
  }
  return rings;
}

/// Part of a displacement that goes round as e^(i order angle).
Complex harmonic(const Ring& ring, std::size_t component, int order) {
  Complex sum = 0.0;
  for (const RingNode& node : ring.nodes) {
    sum += node.weight * node.displacement.at(component) * std::polar(1.0, -order * node.angle);
  }
  return sum / ((order == 0 ? 2.0 : 1.0) * pi);
}

/// Energies of the components with a number of nodal diameters, up to a factor.
std::array<double, 3> energies(const std::vector<Ring>& rings, int order) {
  std::array<double, 3> sums{};
  for (const Ring& ring : rings) {
    for (const std::size_t component : {radial, tangential, axial}) {
      const double power = std::norm(harmonic(ring, component, order));
      sums.at(component) += (order == 0 ? 1.0 : 0.5) * ring.radius * power;
    }
  }
  return sums;
}

double sum_of(const std::array<double, 3>& values) {
  return values[0] + values[1] + values[2];
}

/// How often a component changes its sign from ring to ring.
int nodal_circles(const std::vector<Ring>& rings, std::size_t component, int order) {
  constexpr double share = 0.15;
  std::vector<Complex> values;
  Complex squares = 0.0;  // both sides of a line through zero
  for (const Ring& ring : rings) {
    values.push_back(harmonic(ring, component, order));
    squares += values.back() * values.back();
  }
  std::vector<double> along;
  for (const Complex value : values) {
    along.push_back((value * std::polar(1.0, -0.5 * std::arg(squares))).real());
  }
  return sign_changes(along, share);
}

}  // namespace

KindName kind_in_round_body(const BodyForm& form, const LocalShape& shape) {
  const std::vector<Ring> rings = rings_of(form, shape);
  if (rings.empty()) {
    return {};
  }
  int order = 0;
  for (int other = 1; other <= highest_order; ++other) {
    order = sum_of(energies(rings, other)) > sum_of(energies(rings, order)) ? other : order;
  }
  const std::array<double, 3> found = energies(rings, order);
  if (order == 0 && found[tangential] > 0.5 * sum_of(found)) {
    return {.name = "torsion", .is_counted = true};
  }
  if (form.kind == BodyForm::Kind::disc) {
    return {.name = found[axial] > 0.5 * sum_of(found)
                        ? fmt::format("({}, {})", order, nodal_circles(rings, axial, order))
                        : fmt::format("in plane ({})", order)};
  }
  // A flared lip moves along the axis, too, but the nodal circles of a wall are those of its radial motion.
  const std::size_t component = found[radial] > 0.2 * (found[radial] + found[axial]) ? radial : axial;
  return {.name = fmt::format("({}, {})", order, nodal_circles(rings, component, order))};
}

}  // namespace idiophone::mode_kinds
