#include "idiophone/solid/packed_elements.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <stdexcept>

namespace idiophone::solid {

namespace {

using ElementNodes = std::span<const Index>;
using Positions = std::span<const Vector3>;

const Vector3& position(Positions reference, ElementNodes nodes, int a) {
  return reference[static_cast<std::size_t>(nodes[static_cast<std::size_t>(a)])];
}

/// J[i][k] = dX_i/dxi_k at a quadrature point.
template <class Element>
Eigen::Matrix3d jacobian(int point, ElementNodes nodes, Positions reference) {
  Eigen::Matrix3d j = Eigen::Matrix3d::Zero();
  for (int a = 0; a < Element::nodes; ++a) {
    for (int k = 0; k < 3; ++k) {
      j.col(k) += Element::gradient(point, a, k) * position(reference, nodes, a);
    }
  }
  return j;
}

/// Whether every edge node lies in the middle of its edge, to round-off: then the Jacobian is the same everywhere.
template <class Element>
bool straight_sided(ElementNodes nodes, Positions reference) {
  for (int edge = 4; edge < Element::nodes; ++edge) {
    const auto [i, j] = Tet10::edges[static_cast<std::size_t>(edge - 4)];
    const Vector3& a = position(reference, nodes, i);
    const Vector3& b = position(reference, nodes, j);
    if ((position(reference, nodes, edge) - (a + b) / 2).norm() > 1e-10 * (a - b).norm()) {
      return false;
    }
  }
  return true;
}

}  // namespace

template <class Element>
PackedElements<Element>::PackedElements(const mesh::BodyPart& part, Positions reference)
    : packs_((part.element_ids.size() + lanes - 1) / lanes), count_(static_cast<Index>(part.element_ids.size())) {
  for (std::size_t number = 0; number < packs_.size(); ++number) {
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const std::size_t element = std::min(number * lanes + lane, part.element_ids.size() - 1);
      for (std::size_t a = 0; a < Element::nodes; ++a) {
        packs_[number].nodes[a][lane] = part.elements[element * Element::nodes + a];
      }
    }
    add_geometry(packs_[number], number * lanes, part, reference);
  }
}

template <class Element>
void PackedElements<Element>::add_geometry(ElementPack& pack, std::size_t first, const mesh::BodyPart& part,
                                           Positions reference) {
  Geometry at_points[points];
  bool straight = true;
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    const std::size_t element = std::min(first + lane, part.element_ids.size() - 1);
    const ElementNodes nodes = std::span(part.elements).subspan(element * Element::nodes, Element::nodes);
    const bool element_straight = straight_sided<Element>(nodes, reference);
    straight = straight && element_straight;
    for (int q = 0; q < Element::points; ++q) {
      // A straight element has the same bits at all its points, so it doesn't matter who shares its pack.
      const Eigen::Matrix3d j =
          element_straight ? jacobian<Tet4>(0, nodes, reference) : jacobian<Element>(q, nodes, reference);
      const double determinant = j.determinant();
      if (!(determinant > 0)) {
        throw std::runtime_error(
            fmt::format("element {} is inverted or degenerate: its Jacobian is {:.3g} m3 at a quadrature point",
                        part.element_ids[element], determinant));
      }
      const Eigen::Matrix3d inverse = j.inverse();
      for (int k = 0; k < 3; ++k) {
        for (int i = 0; i < 3; ++i) {
          at_points[q].inverse_jacobian.at[k][i][lane] = inverse(k, i);
        }
      }
      at_points[q].weight[lane] = first + lane == element ? Element::weight * determinant : 0.0;
    }
  }
  pack.geometry = geometry_.size();
  pack.stride = straight ? 0 : 1;
  geometry_.insert(geometry_.end(), at_points, at_points + (straight ? 1 : points));
}

template <class Element>
void PackedElements<Element>::add_mass(double density, std::span<double> mass) const {
  for (std::size_t number = 0; number < packs_.size(); ++number) {
    const ElementPack& pack = packs_[number];
    Pack volume = {};
    for (std::size_t q = 0; q < points; ++q) {
      volume += geometry(pack, q).weight;
    }
    for (int lane = 0; lane < filled_lanes(number); ++lane) {
      for (int a = 0; a < Element::nodes; ++a) {
        mass[static_cast<std::size_t>(pack.nodes[a][lane])] +=
            Element::mass_share[a < 4 ? 0 : 1] * density * volume[lane];
      }
    }
  }
}

template class PackedElements<Tet4>;
template class PackedElements<Tet10>;

}  // namespace idiophone::solid
