#include "idiophone/solids/solid/packed_tetrahedra.hpp"

#include <Eigen/LU>
#include <algorithm>

#include "idiophone/solids/solid/inverted_element.hpp"

namespace idiophone::solid {

namespace {

using ElementNodes = std::span<const Index>;
using Positions = std::span<const Vector3>;

/// J[i][k] = dX_i/dxi_k at a quadrature point.
template <class Element>
Eigen::Matrix3d jacobian(int point, ElementNodes nodes, Positions reference) {
  Eigen::Matrix3d j = Eigen::Matrix3d::Zero();
  for (int a = 0; a < Element::nodes; ++a) {
    for (int k = 0; k < 3; ++k) {
      j.col(k) += Element::gradient(Element::places[point], a, k) * reference[nodes[a]];
    }
  }
  return j;
}

/// Whether every edge node lies in the middle of its edge, to round-off: then the Jacobian is the same everywhere.
template <class Element>
bool straight_sided(ElementNodes nodes, Positions reference) {
  for (int edge = 4; edge < Element::nodes; ++edge) {
    const auto [i, j] = element::tetrahedron_edges[edge - 4];
    const Vector3& a = reference[nodes[i]];
    const Vector3& b = reference[nodes[j]];
    if ((reference[nodes[edge]] - (a + b) / 2).norm() > 1e-10 * (a - b).norm()) {
      return false;
    }
  }
  return true;
}

/// The element in a lane of a pack: its last one in lanes that are padding.
std::size_t element_in(const PackLayout& layout, std::size_t pack, std::size_t lane) {
  return layout.first_element(pack) + std::min(lane, static_cast<std::size_t>(layout.filled_lanes(pack)) - 1);
}

/// Whether all quadrature points have the same weight.
template <class Element>
constexpr bool has_equal_weights() {
  return std::ranges::all_of(Element::weights, [](double weight) { return weight == Element::weights[0]; });
}

}  // namespace

template <class Element>
PackedTetrahedra<Element>::PackedTetrahedra(const mesh::BodyPart& part, Positions reference)
    : layout_(part), packs_(layout_.pack_count()) {
  geometry_.reserve(packs_.size());  // enough for straight linear elements; a vector that grows holds both copies
  for (std::size_t number = 0; number < packs_.size(); ++number) {
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const ElementNodes nodes = part.element_nodes(element_in(layout_, number, lane));
      for (std::size_t a = 0; a < Element::nodes; ++a) {
        packs_[number].nodes[a][lane] = nodes[a];
      }
    }
    add_geometry(number, part, reference);
  }
}

template <class Element>
void PackedTetrahedra<Element>::add_geometry(std::size_t number, const mesh::BodyPart& part, Positions reference) {
  ElementPack& pack = packs_[number];
  Geometry at_points[points()];
  bool straight = true;
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    const std::size_t element = element_in(layout_, number, lane);
    const ElementNodes nodes = part.element_nodes(element);
    const bool is_filled = static_cast<int>(lane) < layout_.filled_lanes(number);
    const bool element_straight = straight_sided<Element>(nodes, reference);
    straight = straight && element_straight;
    for (int q = 0; q < Element::points; ++q) {
      // A straight element has the same bits at all its points, so it doesn't matter who shares its pack.
      const Eigen::Matrix3d j =
          element_straight ? jacobian<element::Tet4>(0, nodes, reference) : jacobian<Element>(q, nodes, reference);
      const double determinant = j.determinant();
      if (!(determinant > 0)) {
        throw InvertedElement(part.element_ids[element], determinant);
      }
      const Eigen::Matrix3d inverse = j.inverse();
      for (int k = 0; k < 3; ++k) {
        for (int i = 0; i < 3; ++i) {
          at_points[q].inverse_jacobian.at[k][i][lane] = inverse(k, i);
        }
      }
      at_points[q].weight[lane] = is_filled ? Element::weights[q] * determinant : 0.0;
    }
  }
  const bool shared = straight && has_equal_weights<Element>();
  pack.geometry = geometry_.size();
  pack.stride = shared ? 0 : 1;
  geometry_.insert(geometry_.end(), at_points, at_points + (shared ? 1 : points()));
}

template <class Element>
void PackedTetrahedra<Element>::add_mass(double density, PackRange range, std::span<double> mass) const {
  for (std::size_t number = range.begin; number < range.end; ++number) {
    const ElementPack& pack = packs_[number];
    Pack volume = {};
    for (std::size_t q = 0; q < points(); ++q) {
      volume += geometry(pack, q).weight;
    }
    for (int lane = 0; lane < layout_.filled_lanes(number); ++lane) {
      for (int a = 0; a < Element::nodes; ++a) {
        mass[pack.nodes[a][lane]] += Element::mass_shares[a] * density * volume[lane];
      }
    }
  }
}

template class PackedTetrahedra<element::Tet4>;
template class PackedTetrahedra<element::Tet10>;

}  // namespace idiophone::solid
